#pragma once
// Meshes from PLY files: text, and binary of both byte orders.
//
// Of the element "vertex" are read x y z, nx ny nz if all three are there, and the first of the pairs u v, s t,
// texture_u texture_v, texture_s texture_t; of "face" the list vertex_indices (or vertex_index). All else is skipped.
// As in pbrt-v4 a face of four corners is a bilinear patch, and faces of more or fewer than three or four are left out.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>

namespace emulsion {

struct PlyMesh {
    std::vector<Imath::V3f> position;
    std::vector<Imath::V3f> normal;  ///< one a position, or none
    std::vector<Imath::V2f> uv;      ///< one a position, or none
    std::vector<std::array<std::uint32_t, 3>> triangle;
    std::vector<std::array<std::uint32_t, 4>> patch;  ///< p00 p10 p01 p11, so no longer in the order of a walk round
    std::size_t other_faces = 0;                      ///< left out
    std::size_t bad_normals = 0;                      ///< not finite: set to 0
};

/// \throws IoError naming `path`, the line or the byte, what was found there and what was expected: for files that end
/// early or announce more than they hold, for indices without a vertex, and for positions and texture coordinates that
/// single precision does not hold.
[[nodiscard]] PlyMesh read_ply(const std::filesystem::path& path, std::string_view bytes);

}  // namespace emulsion
