#pragma once
// The basis model: K functions fitted to the spectra of one scene.
//
// Spectra are projected on the K-dimensional space that holds the observer's three functions, so that light seen
// directly is exact, and beyond them the main components of what occurs in the scene: its lights, after no, one and two
// reflections. Reflection by R is then the matrix <v_i, R v_j>, which Peercy's method multiplies out. A path tracer
// multiplies at every vertex, and we want it to be K numbers times K numbers: so among the orthonormal bases of the
// space, the one is taken in which these matrices are closest to diagonal, and the rest of them is left out. Its
// functions are narrow, each somewhere else in the spectrum; r_k is the mean of R weighted by v_k^2, changed by the
// least that makes one reflection of the scene's light exact. Without that change it lies in [0, 1] where R does.
//
// Sources: Peercy, "Linear Color Representations for Full Spectral Rendering", SIGGRAPH 1993 (projection on main
// components, section 3); Drew & Finlayson, "Multispectral Processing Without Spectra", JOSA A 20(7), 2003 (a sharpened
// basis, products by component); Cardoso & Souloumiac, "Jacobi Angles for Simultaneous Diagonalization", SIAM J. Matrix
// Anal. 17(1), 1996. Peercy's basis isn't weighted by what the eye sees, ours is: by xbar + ybar + zbar.

#include <vector>

#include "pathtracer/fixed_channels.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// What the spectra of a scene are.
struct SceneSpectra {
    struct WeightedLight {
        Spectrum spectrum;
        double flux = 1.0;  ///< > 0; of all lights with this spectrum, relative
    };
    std::vector<WeightedLight> lights;
    std::vector<Spectrum> reflectances;
};

/// Of all lights by their flux; equal energy if there are none.
[[nodiscard]] Spectrum sum_of_lights(const SceneSpectra& spectra);

/// `functions` in [3, kMostBasisFunctions]. Without lights, equal energy is taken for one.
/// \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] FixedChannels basis_channels(const SceneSpectra& spectra, int functions);

}  // namespace emulsion
