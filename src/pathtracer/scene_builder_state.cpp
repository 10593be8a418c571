// The graphics state: what it is, and what saves it and brings it back.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pathtracer/scene_builder.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

// --- Transformations

namespace {

void check_transform(const SourcePlace& place, const Imath::M44d& matrix) {
    if (!is_affine(matrix)) {
        throw SceneError(place, "a projective transformation", "an affine one: numbers 4, 8, 12, 16 are 0 0 0 1");
    }
    if (!is_invertible(matrix)) {
        throw SceneError(place, "a singular transformation",
                         "one that maps space to space, neither flattened nor overflowing");
    }
}

}  // namespace

template <class Change>
void SceneBuilder::change_transforms(const SourcePlace& place, const Change& change) {
    const auto apply = [&](Imath::M44d& matrix) {
        const Imath::M44d changed = change(matrix);
        check_transform(place, changed);
        matrix = changed;
    };
    if (state_.active != ActiveTransform::end_time) apply(state_.frame.world_from_object);
    if (state_.active != ActiveTransform::start_time) apply(state_.world_from_object_at_end);
}

void SceneBuilder::transform(const SourcePlace& place, const Imath::M44d& matrix) {
    change_transforms(place, [&](const Imath::M44d&) { return matrix; });
}

void SceneBuilder::concat_transform(const SourcePlace& place, const Imath::M44d& matrix) {
    check_transform(place, matrix);
    change_transforms(place, [&](const Imath::M44d& current) { return matrix * current; });
}

bool SceneBuilder::is_moving() const noexcept {
    return state_.frame.world_from_object != state_.world_from_object_at_end;
}

void SceneBuilder::require_rest(const SourcePlace& place, std::string_view what) const {
    if (!is_moving()) return;
    throw SceneError(place, fmt::format("{} that moves while the shutter is open", what),
                     "one at rest: ActiveTransform StartTime and EndTime may not differ here");
}

void SceneBuilder::warn_of_motion(const SourcePlace& place, std::string_view what) {
    if (is_moving()) warn(place, fmt::format("{} is taken to rest where it is as the shutter opens", what));
}

void SceneBuilder::coordinate_system(const std::string& name) {
    coordinate_systems_[name] = {state_.frame.world_from_object, state_.world_from_object_at_end};
}

void SceneBuilder::coord_sys_transform(const SourcePlace& place_of_name, const std::string& name) {
    const auto found = coordinate_systems_.find(name);
    if (found != coordinate_systems_.end()) {
        state_.frame.world_from_object = found->second[0];
        state_.world_from_object_at_end = found->second[1];
        return;
    }
    std::vector<std::string_view> known;
    for (const auto& entry : coordinate_systems_) known.push_back(entry.first);
    warn(place_of_name, fmt::format("unknown coordinate system {}: the transformation stays as it is{}", quote(name),
                                    nearest_hint(name, known)));
}

// --- What later directives take over

void SceneBuilder::color_space(const SourcePlace& place_of_name, const std::string& name) {
    state_.color_space = color_space_of(place_of_name, name);
}

void SceneBuilder::attribute(const SourcePlace&, ParameterList list) {
    using Table = const ImplementationTable& (*)();
    struct Target {
        std::string_view name;
        AttributeTarget target;
        std::array<Table, 2> tables;  // of those who take them; null: no more
    };
    constexpr auto kTargets = std::to_array<Target>(
        {{"shape", AttributeTarget::shape, {shape_table}},
         {"light", AttributeTarget::light, {light_table, area_light_table}},
         {"material", AttributeTarget::material, {material_table}},
         {"medium", AttributeTarget::medium, {}},
         {"texture", AttributeTarget::texture, {float_texture_table, reflectance_texture_table}}});
    const auto& row = supported_row<Target>(list.place, {"attribute target"}, list.owner, kTargets);
    auto& attributes = state_.attributes.at(static_cast<std::size_t>(row.target));
    if (!attributes) {
        attributes = std::make_shared<InheritedParameters>();
    } else if (attributes.use_count() > 1) {
        attributes = std::make_shared<InheritedParameters>(*attributes);
    }
    for (SceneParameter& parameter : list.parameters) {
        // What nobody takes is not kept, so that the names that are kept are few.
        const auto knows = [&](Table table) { return table != nullptr && knows_parameter(table(), parameter.name); };
        if (std::ranges::none_of(row.tables, knows)) continue;
        auto& kept = (*attributes)[parameter.name];
        kept = std::make_shared<const SceneParameter>(std::move(parameter));
    }
}

void SceneBuilder::inherit(AttributeTarget target, const ImplementationTable& table, ParameterList& list) const {
    const auto& attributes = state_.attributes.at(static_cast<std::size_t>(target));
    if (attributes) inherit_parameters(table, list, *attributes);
}

void SceneBuilder::medium_interface(const SourcePlace& place_of_name, const std::string& name) {
    if (name.empty()) return;
    throw SceneError(place_of_name, "the medium " + quote(name), "\"\": media are not supported here");
}

void SceneBuilder::reverse_orientation() noexcept {
    const bool reversed = state_.frame.orientation == Orientation::reversed;
    state_.frame.orientation = reversed ? Orientation::as_given : Orientation::reversed;
}

// --- What saves the state and brings it back

void SceneBuilder::begin_block(const SourcePlace& place, BlockKind kind, std::string_view directive) {
    open_blocks_.push_back({state_, place, kind, directive});
}

void SceneBuilder::end_block(const SourcePlace& place, BlockKind kind, std::string_view directive) {
    if (open_blocks_.empty()) {
        throw SceneError(place, fmt::format("{0}End without its {0}Begin", directive), "as many of one as the other");
    }
    const OpenBlock& open = open_blocks_.back();
    if (open.kind != kind) {
        throw SceneError(place, fmt::format("{}End", directive),
                         fmt::format("the {0}End of the {0}Begin at {1}", open.directive, to_text(open.begin)));
    }
    state_ = std::move(open_blocks_.back().outside);
    open_blocks_.pop_back();
}

void SceneBuilder::require_closed_blocks() const {
    if (open_blocks_.empty()) return;
    const OpenBlock& open = open_blocks_.back();
    throw SceneError(open.begin, fmt::format("{0}Begin without its {0}End", open.directive),
                     "as many of one as the other");
}

void SceneBuilder::attribute_begin(const SourcePlace& place) { begin_block(place, BlockKind::attribute, "Attribute"); }
void SceneBuilder::attribute_end(const SourcePlace& place) { end_block(place, BlockKind::attribute, "Attribute"); }

void SceneBuilder::transform_begin(const SourcePlace& place) {
    if (!std::exchange(warned_of_transform_begin_, true)) {
        warn(place, "TransformBegin is deprecated, and means AttributeBegin: it saves more than the transformation");
    }
    begin_block(place, BlockKind::attribute, "Transform");
}
void SceneBuilder::transform_end(const SourcePlace& place) { end_block(place, BlockKind::attribute, "Transform"); }

void SceneBuilder::import_begin() {
    open_imports_.push_back({state_, std::exchange(open_blocks_, {}), std::exchange(coordinate_systems_, {})});
}

void SceneBuilder::import_end() {
    require_closed_blocks();
    state_ = std::move(open_imports_.back().outside);
    open_blocks_ = std::move(open_imports_.back().blocks);
    coordinate_systems_ = std::move(open_imports_.back().coordinate_systems);
    open_imports_.pop_back();
}

// --- Objects

void SceneBuilder::object_begin(const SourcePlace& place, const std::string& name) {
    if (open_object_) {
        throw SceneError(place, "ObjectBegin inside an object",
                         "the ObjectEnd of the ObjectBegin at " + to_text(object_places_.at(*open_object_)));
    }
    const auto [entry, added] = objects_.try_emplace(name, scene_.objects.size());
    if (!added) {
        throw SceneError(place, fmt::format("a second object {}", quote(name)),
                         "each name only once (the first is at " + to_text(object_places_.at(entry->second)) + ")");
    }
    begin_block(place, BlockKind::object, "Object");
    open_object_ = entry->second;
    scene_.objects.push_back({name, {}});
    object_origins_.push_back(state_.frame.world_from_object.translation());
    object_places_.push_back(place);
}

void SceneBuilder::object_end(const SourcePlace& place) {
    end_block(place, BlockKind::object, "Object");
    open_object_.reset();
}

void SceneBuilder::object_instance(const SourcePlace& place, const SourcePlace& place_of_name,
                                   const std::string& name) {
    if (open_object_) {
        throw SceneError(place, "ObjectInstance inside an object",
                         "it outside: objects are made of shapes only, as in pbrt-v4");
    }
    require_rest(place, "an instance");
    instance_uses_.push_back({name, place_of_name, state_.frame.world_from_object});
}

namespace {

/// \throws SceneError for an instance that single precision can't hold, or can't hold the inverse of.
void check_instance_reach(const SourcePlace& place, const Imath::M44d& world_from_object) {
    const std::optional<Imath::M44d> inverse = inverse_of(world_from_object);
    double largest = inverse ? 0.0 : HUGE_VAL;
    for (int i = 0; i < 4 && inverse; ++i) {
        for (int j = 0; j < 3; ++j) {
            largest = std::max({largest, std::abs(world_from_object[i][j]), std::abs((*inverse)[i][j])});
        }
    }
    if (largest <= kReach) return;
    throw SceneError(place, fmt::format("an instance whose transformation, or its inverse, reaches {:g}", largest),
                     std::string(kWithinReach));
}

}  // namespace

void SceneBuilder::resolve_instances() {
    for (const InstanceUse& use : instance_uses_) {
        const auto object = objects_.find(use.object);
        if (object == objects_.end()) {
            std::vector<std::string_view> known;
            for (const auto& entry : objects_) known.push_back(entry.first);
            throw SceneError(use.place_of_name, "unknown object " + quote(use.object),
                             "one that ObjectBegin makes" + nearest_hint(use.object, known));
        }
        const Imath::V3d& origin = object_origins_.at(static_cast<std::size_t>(object->second));
        const Imath::M44d placed = from_camera_position(translation(origin) * use.world_from_object);
        check_instance_reach(use.place_of_name, placed);
        scene_.instances.push_back({static_cast<int>(object->second), placed});
    }
}

}  // namespace emulsion
