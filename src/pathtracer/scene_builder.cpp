#include "pathtracer/scene_builder.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "pathtracer/scene_departures.h"
#include "pathtracer/scene_materials.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

/// Moves the camera to the origin; returns where it was.
Imath::V3d moved_to_origin(Camera& camera) {
    return std::visit(
        [](auto& c) {
            const Imath::V3d position = c.world_from_camera.translation();
            c.world_from_camera = c.world_from_camera * translation(-position);
            return position;
        },
        camera);
}

}  // namespace

// --- Options

void SceneBuilder::camera(const SourcePlace& place, const ParameterList& list) {
    note_option(place, "Camera");
    require_rest(list.place, "a camera");
    scene_.camera = read_camera(list, state_.frame.world_from_object, exposure_time_s_, warnings_);
    const Imath::M44d world_from_camera = std::visit([](const auto& c) { return c.world_from_camera; }, scene_.camera);
    coordinate_systems_["camera"] = {world_from_camera, world_from_camera};
}

void SceneBuilder::film(const SourcePlace& place, const ParameterList& list) {
    note_option(place, "Film");
    read_film(list, scene_.film, warnings_);
}

void SceneBuilder::sampler(const SourcePlace& place, const ParameterList& list) {
    note_option(place, "Sampler");
    ReadSampler read = read_sampler(list);
    scene_.sampler = read.sampler;
    sampler_seed_ = read.seed;
    if (!read.warning.empty()) warn(list.place, read.warning);
}

void SceneBuilder::pixel_filter(const SourcePlace& place, const ParameterList& list) {
    note_option(place, "PixelFilter");
    scene_.filter = read_filter(list);
}

void SceneBuilder::integrator(const SourcePlace& place, const ParameterList& list) {
    note_option(place, "Integrator");
    const ReadIntegrator read = read_integrator(list);
    scene_.integrator = read.settings;
    if (!read.warning.empty()) warn(list.place, read.warning);
}

void SceneBuilder::accelerator(const SourcePlace& place, const ParameterList& list) {
    note_option(place, "Accelerator");
    check_parameters(accelerator_table(), list);  // how rays are traced is no part of the picture
}

void SceneBuilder::option(const Token& name, const Token& value) {
    const std::string warning = read_global_option(name, value, options_);
    if (!warning.empty()) warn(name.place, warning);
}

void SceneBuilder::note_option(const SourcePlace& place, const std::string& directive) {
    const auto [earlier, first] = options_seen_.try_emplace(directive, place);
    if (first) return;
    warn(place, fmt::format("{} replaces the one at {}", directive, to_text(earlier->second)));
    earlier->second = place;
}

void SceneBuilder::world_begin(const SourcePlace& place) {
    block_ = SceneBlock::world;
    world_begin_ = place;
    scene_.film.sensor.exposure_time_s = exposure_time_s_;
    check_sensor(place, scene_.film.sensor);
    scene_.origin = moved_to_origin(scene_.camera);
    state_.frame.world_from_object.makeIdentity();
    state_.world_from_object_at_end.makeIdentity();
    state_.active = ActiveTransform::all;
    coordinate_system("world");
}

/// From the world of the file to the scene's, whose origin is the camera.
Imath::M44d SceneBuilder::from_camera_position(const Imath::M44d& world_from_object) const {
    return world_from_object * translation(-scene_.origin);
}

// --- World

Material SceneBuilder::read_material(const ParameterList& list) {
    if (list.owner.empty() || list.owner == "none") {
        warn(list.place, fmt::format("the material {} is taken as \"interface\", as in pbrt-v4{}", quote(list.owner),
                                     list.parameters.empty() ? "" : ", and its parameters have no effect"));
        return InterfaceMaterial{};
    }
    const auto named = [this](const SourcePlace& place, const std::string& name) {
        NamedMaterial& slot = named_slot(name);
        if (!slot.first_use) slot.first_use = place;
        return slot.material;
    };
    Material material = emulsion::read_material(list, {textures_, spectra_, named});
    if (const std::string departure = departure_of(material); !departure.empty()) warn(list.place, departure);
    return material;
}

int SceneBuilder::add_material(Material material) {
    scene_.materials.push_back(std::move(material));
    return static_cast<int>(scene_.materials.size()) - 1;
}

SceneBuilder::NamedMaterial& SceneBuilder::named_slot(const std::string& name) {
    const auto [slot, added] = named_materials_.try_emplace(name);
    if (added) slot->second.material = add_material(DiffuseMaterial{});
    return slot->second;
}

void SceneBuilder::material(const SourcePlace&, ParameterList list) {
    inherit(AttributeTarget::material, material_table(), list);
    state_.material = add_material(read_material(list));
}

void SceneBuilder::make_named_material(const SourcePlace& place, ParameterList list) {
    // The directive's string is the material's name; which material it is, a parameter says.
    const std::string name = std::exchange(list.owner, "");
    const auto is_type = [](const SceneParameter& p) { return p.name == "type" && p.type == DeclaredType::string; };
    const auto type = std::find_if(list.parameters.begin(), list.parameters.end(), is_type);
    if (type == list.parameters.end()) {
        throw SceneError(list.place, fmt::format("the material {} without a type", quote(name)),
                         "a parameter \"string type\"");
    }
    if (type->strings.size() != 1) {
        throw SceneError(type->place, fmt::format("{} types of one material", type->strings.size()), "1");
    }
    list.owner = type->strings.front();
    list.place = type->first_value;
    list.parameters.erase(type);
    inherit(AttributeTarget::material, material_table(), list);
    Material made = read_material(list);

    NamedMaterial& slot = named_slot(name);
    if (slot.made) {
        throw SceneError(place, fmt::format("a second material {}", quote(name)),
                         "each name only once (the first is at " + to_text(*slot.made) + ")");
    }
    slot.made = place;
    scene_.materials[static_cast<std::size_t>(slot.material)] = std::move(made);
}

void SceneBuilder::named_material(const SourcePlace& place, const std::string& name) {
    NamedMaterial& slot = named_slot(name);
    if (!slot.first_use) slot.first_use = place;
    state_.material = slot.material;
}

void SceneBuilder::texture(const TextureDeclaration& declaration, ParameterList list) {
    inherit(AttributeTarget::texture, declaration.kind == "float" ? float_texture_table() : reflectance_texture_table(),
            list);
    warn_of_motion(list.place, "the texture");
    textures_.make(declaration, list,
                   {scene_, spectra_, files_, warnings_, from_camera_position(state_.frame.world_from_object)});
}

void SceneBuilder::area_light_source(const SourcePlace&, ParameterList list) {
    inherit(AttributeTarget::light, area_light_table(), list);
    state_.area_light = std::make_shared<const AreaLightSource>(read_area_light(list, spectra_));
}

void SceneBuilder::light_source(const SourcePlace&, ParameterList list) {
    inherit(AttributeTarget::light, light_table(), list);
    warn_of_motion(list.place, "the light");
    scene_.lights.push_back(
        read_light(list, {from_camera_position(state_.frame.world_from_object), spectra_, files_, warnings_}));
}

void SceneBuilder::shape(const SourcePlace&, ParameterList list) {
    require_rest(list.place, "a shape");
    inherit(AttributeTarget::shape, shape_table(), list);
    if (state_.area_light && open_object_) {
        warn(list.place, "a shape of an object gives no light, as in pbrt-v4: its AreaLightSource is left out");
    }
    ShapeFrame frame = state_.frame;
    frame.world_from_object = open_object_ ? frame.world_from_object * translation(-object_origins_.at(*open_object_))
                                           : from_camera_position(frame.world_from_object);
    for (Geometry& geometry : read_shape(list, frame, {files_, warnings_})) {
        if (state_.area_light && !open_object_) {
            const std::string departure = departure_of_light(geometry);
            if (!departure.empty()) warn(list.place, departure);
        }
        add_shape(std::move(geometry));
    }
}

void SceneBuilder::add_shape(Geometry geometry) {
    Shape shape;
    shape.material = state_.material;
    if (shape.material < 0) {
        if (default_material_ < 0) default_material_ = add_material(DiffuseMaterial{});
        shape.material = default_material_;
    }
    if (state_.area_light && !open_object_) {
        shape.area_light = light_of_shape(*state_.area_light, light_areas(geometry));
    }
    shape.geometry = std::move(geometry);
    auto& shapes = open_object_ ? scene_.objects[*open_object_].shapes : scene_.shapes;
    shapes.push_back(std::move(shape));
}

// --- The end

void SceneBuilder::check_named_materials() const {
    std::vector<std::string_view> made;
    const std::pair<const std::string, NamedMaterial>* missing = nullptr;
    for (const auto& entry : named_materials_) {
        const NamedMaterial& material = entry.second;
        if (material.made) made.push_back(entry.first);
        const bool first = missing == nullptr || material.first_use->offset < missing->second.first_use->offset;
        if (!material.made && first) missing = &entry;
    }
    if (missing == nullptr) return;
    throw SceneError(*missing->second.first_use, "unknown named material " + quote(missing->first),
                     "one that MakeNamedMaterial makes" + nearest_hint(missing->first, made));
}

void SceneBuilder::check_mixes() const {
    const auto place_of = [this](std::size_t material) {
        const auto is_it = [material](const auto& e) {
            return static_cast<std::size_t>(e.second.material) == material;
        };
        const auto entry = std::find_if(named_materials_.begin(), named_materials_.end(), is_it);
        return entry == named_materials_.end() ? *world_begin_ : *entry->second.made;
    };
    if (const auto endless = endless_mix(scene_.materials)) {
        throw SceneError(place_of(*endless), "a mix that is part of itself", "one of other materials");
    }
    for (const auto& [name, named] : named_materials_) {
        const Material& material = scene_.materials[static_cast<std::size_t>(named.material)];
        if (!std::holds_alternative<InterfaceMaterial>(material) || !named.first_use) continue;
        for (const Material& other : scene_.materials) {
            const auto* mix = std::get_if<MixMaterial>(&other);
            if (mix == nullptr || (mix->first != named.material && mix->second != named.material)) continue;
            throw SceneError(*named.made, fmt::format("the interface {} as part of a mix", quote(name)),
                             "another material (known to pbrt-v4 and not yet supported here)");
        }
    }
}

void SceneBuilder::leave_out_interfaces(std::vector<Shape>& shapes) {
    const auto is_interface = [this](const Shape& shape) {
        return std::holds_alternative<InterfaceMaterial>(scene_.materials[static_cast<std::size_t>(shape.material)]);
    };
    const auto emits = [&](const Shape& shape) { return is_interface(shape) && shape.area_light; };
    if (const auto dark = std::count_if(shapes.begin(), shapes.end(), emits); dark > 0) {
        warn(*world_begin_,
             fmt::format("{} area light{} of material \"interface\": without a surface, they give no light", dark,
                         dark == 1 ? "" : "s"));
    }
    std::erase_if(shapes, is_interface);
}

Scene SceneBuilder::finish(const SourcePlace& end) {
    if (!world_begin_) throw SceneError(end, "the end of the file", "WorldBegin");
    require_closed_blocks();
    check_named_materials();
    check_mixes();
    leave_out_interfaces(scene_.shapes);
    for (ObjectDefinition& object : scene_.objects) leave_out_interfaces(object.shapes);
    resolve_instances();
    scene_.sampler_seed = sampler_seed_.value_or(options_.seed);
    scene_.jitter = options_.jitter;

    const auto emits = [](const Shape& shape) { return shape.area_light.has_value(); };
    if (scene_.lights.empty() && std::none_of(scene_.shapes.begin(), scene_.shapes.end(), emits)) {
        warn(*world_begin_, "there is no light: the picture will be black");
    }
    scene_.warnings = warnings_.list();
    return std::move(scene_);
}

}  // namespace emulsion
