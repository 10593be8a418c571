#include "film/aux_batch.h"

#include <stdexcept>
#include <string>

namespace emulsion {

void validate(const BatchAux& aux, const std::vector<AuxLayer>& layers, std::size_t samples) {
    if (aux.layer >= layers.size()) {
        throw std::invalid_argument("sample batch: layer is " + std::to_string(aux.layer) +
                                    ", expected the number of one of the film's " + std::to_string(layers.size()) +
                                    " auxiliary layers");
    }
    const std::size_t expected = samples * layers[aux.layer].components.size();
    if (aux.values.size() == expected) return;
    throw std::invalid_argument("sample batch: values has " + std::to_string(aux.values.size()) +
                                " numbers, expected " + std::to_string(expected));
}

}  // namespace emulsion
