#include "pathtracer/scene_material.h"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace emulsion {

std::optional<std::size_t> endless_mix(const std::vector<Material>& materials) {
    // Depth first; a material is open while those that it consists of are being followed.
    enum class State : std::uint8_t { unseen, open, ends };
    std::vector<State> states(materials.size(), State::unseen);
    std::vector<std::size_t> stack;
    for (std::size_t start = 0; start < materials.size(); ++start) {
        stack.push_back(start);
        while (!stack.empty()) {
            const std::size_t top = stack.back();
            const auto* mix = std::get_if<MixMaterial>(&materials[top]);
            if (states[top] != State::unseen || mix == nullptr) {
                states[top] = State::ends;
                stack.pop_back();
                continue;
            }
            states[top] = State::open;
            for (const int part : {mix->first, mix->second}) {
                const auto i = static_cast<std::size_t>(part);
                if (i >= materials.size()) {
                    throw std::invalid_argument("mix material " + std::to_string(top) + ": part " +
                                                std::to_string(part) + " must be one of " +
                                                std::to_string(materials.size()) + " materials");
                }
                if (states[i] == State::open) return top;
                if (states[i] == State::unseen) stack.push_back(i);
            }
        }
    }
    return std::nullopt;
}

}  // namespace emulsion
