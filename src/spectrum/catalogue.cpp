#include "spectrum/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "core/name_key.h"
#include "core/nearest_name.h"
#include "core/units.h"
#include "spectrum/catalogue_names.h"
#include "spectrum/data_table.h"
#include "spectrum/sellmeier.h"

namespace emulsion {

namespace {

struct Catalogue {
    std::vector<NamedSpectrumInfo> entries;
    std::map<std::string, std::size_t, std::less<>> by_key;
};

// The distance between the knots if they are evenly spaced to a tenth of a picometre, else 0.
double even_step_nm(const std::vector<double>& lambda_nm) {
    const double step_nm = lambda_nm[1] - lambda_nm[0];
    for (std::size_t i = 2; i < lambda_nm.size(); ++i) {
        if (std::abs(lambda_nm[i] - lambda_nm[i - 1] - step_nm) > 1e-4) return 0.0;
    }
    return step_nm;
}

void describe_range(NamedSpectrumInfo& entry) {
    const DataTable& table = data_table(entry.table);
    entry.source = table.comment;
    if (entry.table == kGlassTable) {
        entry.first_nm = kMinWavelength_nm;
        entry.last_nm = kMaxWavelength_nm;
        entry.step_nm = 1.0;
        return;
    }
    const std::vector<double> lambda_nm = wavelengths_nm(table);
    entry.first_nm = lambda_nm.front();
    entry.last_nm = lambda_nm.back();
    entry.step_nm = even_step_nm(lambda_nm);
}

const Catalogue& catalogue() {
    static const Catalogue complete = [] {
        Catalogue made;
        std::vector<NamedSpectrumInfo> all = named_columns();
        for (const std::string_view group : spectrum_groups()) {
            for (NamedSpectrumInfo& entry : all) {
                if (entry.group != group || made.by_key.contains(name_key(entry.name))) continue;
                describe_range(entry);
                for (const std::string& alias : entry.aliases) made.by_key[name_key(alias)] = made.entries.size();
                made.by_key[name_key(entry.name)] = made.entries.size();
                made.entries.push_back(std::move(entry));
            }
        }
        return made;
    }();
    return complete;
}

PiecewiseLinearSpectrum sellmeier_spectrum(const std::string& name) {
    const SellmeierGlass& glass = sellmeier_glass(name);
    PiecewiseLinearSpectrum index;
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        index.lambda_nm.push_back(lambda_nm);
        index.value.push_back(extrapolated_index(glass, lambda_nm));
    }
    return index;
}

/// \throws std::invalid_argument always.
[[noreturn]] void throw_unknown_spectrum(std::string_view name) {
    constexpr std::size_t kListed = 5, kLongestName = 64;  // a longer one is like none of ours
    std::vector<std::pair<std::size_t, std::string_view>> ranked;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        std::size_t distance = name_distance(name.substr(0, kLongestName), entry.name);
        for (const std::string& alias : entry.aliases) {
            distance = std::min(distance, name_distance(name.substr(0, kLongestName), alias));
        }
        ranked.emplace_back(distance, entry.name);
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string nearest;
    for (std::size_t i = 0; i < kListed; ++i) {
        if (i > 0) nearest += i + 1 == kListed ? " or " : ", ";
        nearest += ranked[i].second;
    }
    throw std::invalid_argument(fmt::format("spectrum \"{}\": unknown; nearest of the {} names in the catalogue: {}",
                                            name, ranked.size(), nearest));
}

}  // namespace

std::vector<std::string_view> spectrum_groups() {
    return {kIlluminantGroup, kEmissionGroup,   kReflectanceGroup, kIndexGroup,
            kExtinctionGroup, kEfficiencyGroup, kMatchingGroup,    kDaylightGroup};
}

const std::vector<NamedSpectrumInfo>& spectrum_catalogue() { return catalogue().entries; }

const NamedSpectrumInfo* find_in_catalogue(std::string_view name) {
    const auto found = catalogue().by_key.find(name_key(name));
    return found == catalogue().by_key.end() ? nullptr : &catalogue().entries[found->second];
}

PiecewiseLinearSpectrum spectrum_of(const NamedSpectrumInfo& entry) {
    if (entry.table == kGlassTable) return sellmeier_spectrum(entry.column);
    return tabulated_spectrum(entry.table, entry.column);
}

PiecewiseLinearSpectrum catalogue_spectrum(std::string_view name) {
    if (const NamedSpectrumInfo* const entry = find_in_catalogue(name)) return spectrum_of(*entry);
    throw_unknown_spectrum(name);
}

}  // namespace emulsion
