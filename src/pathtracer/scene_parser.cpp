#include "pathtracer/scene_parser.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/content_hash.h"
#include "core/text_file.h"
#include "pathtracer/scene_builder.h"
#include "pathtracer/scene_lexer.h"
#include "pathtracer/scene_texts.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

// --- What follows a directive

/// What a directive acts on.
struct Reading {
    Lexer& lexer;
    SceneBuilder& scene;
    SceneTexts& texts;
    Token directive;
};

template <std::size_t N>
std::array<double, N> read_numbers(Lexer& lexer) {
    const bool brackets = lexer.peek().kind == TokenKind::open_bracket;
    if (brackets) lexer.next();
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) {
        numbers[i] = number_value(lexer.next(), fmt::format("a number, the {} of {}", i + 1, N));
    }
    if (!brackets) return numbers;
    const Token close = lexer.next();
    if (close.kind != TokenKind::close_bracket) {
        throw SceneError(close.place, describe(close), fmt::format("a \"]\" after {} numbers", N));
    }
    return numbers;
}

Token read_string(Lexer& lexer, const Token& directive) {
    const Token token = lexer.next();
    if (token.kind == TokenKind::string) return token;
    throw SceneError(token.place, describe(token), fmt::format("a string after {}", directive.text));
}

/// The parameters of an implementation that `owner` names.
ParameterList read_list(Reading& r, const Token& owner) {
    ParameterList list{string_value(owner), owner.place, read_parameters(r.lexer), r.scene.color_space()};
    for (SceneParameter& parameter : list.parameters) parameter.color_space = list.color_space;
    return list;
}

// --- The directives

void run_identity(Reading& r) { r.scene.transform(r.directive.place, Imath::M44d()); }
void run_transform(Reading& r) { r.scene.transform(r.directive.place, matrix_of_columns(read_numbers<16>(r.lexer))); }
void run_concat_transform(Reading& r) {
    r.scene.concat_transform(r.directive.place, matrix_of_columns(read_numbers<16>(r.lexer)));
}
void run_translate(Reading& r) {
    const auto n = read_numbers<3>(r.lexer);
    r.scene.concat_transform(r.directive.place, translation({n[0], n[1], n[2]}));
}
void run_scale(Reading& r) {
    const auto n = read_numbers<3>(r.lexer);
    r.scene.concat_transform(r.directive.place, scaling({n[0], n[1], n[2]}));
}
void run_rotate(Reading& r) {
    const auto n = read_numbers<4>(r.lexer);
    if (n[1] == 0.0 && n[2] == 0.0 && n[3] == 0.0) {
        throw SceneError(r.directive.place, "Rotate about 0 0 0", "an axis of some length");
    }
    r.scene.concat_transform(r.directive.place, rotation(n[0], {n[1], n[2], n[3]}));
}
void run_look_at(Reading& r) {
    const auto n = read_numbers<9>(r.lexer);
    const Imath::M44d matrix = look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
    if (!is_invertible(matrix)) {
        throw SceneError(r.directive.place, "LookAt whose eye, look and up give no frame",
                         "two points apart, and an up direction that is not along the line between them");
    }
    r.scene.concat_transform(r.directive.place, matrix);
}

void run_world_begin(Reading& r) { r.scene.world_begin(r.directive.place); }
void run_attribute_begin(Reading& r) { r.scene.attribute_begin(r.directive.place); }
void run_attribute_end(Reading& r) { r.scene.attribute_end(r.directive.place); }
void run_reverse_orientation(Reading& r) { r.scene.reverse_orientation(); }
void run_transform_begin(Reading& r) { r.scene.transform_begin(r.directive.place); }
void run_transform_end(Reading& r) { r.scene.transform_end(r.directive.place); }
void run_object_end(Reading& r) { r.scene.object_end(r.directive.place); }
void run_object_begin(Reading& r) {
    r.scene.object_begin(r.directive.place, string_value(read_string(r.lexer, r.directive)));
}
void run_object_instance(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    r.scene.object_instance(r.directive.place, name.place, string_value(name));
}
void run_named_material(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    r.scene.named_material(name.place, string_value(name));
}
void run_coordinate_system(Reading& r) { r.scene.coordinate_system(string_value(read_string(r.lexer, r.directive))); }
void run_coord_sys_transform(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    r.scene.coord_sys_transform(name.place, string_value(name));
}
void run_color_space(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    r.scene.color_space(name.place, string_value(name));
}
void run_active_transform(Reading& r) {
    struct Which {
        std::string_view name;
        ActiveTransform active;
    };
    constexpr auto kWhich = std::to_array<Which>({{"All", ActiveTransform::all},
                                                  {"StartTime", ActiveTransform::start_time},
                                                  {"EndTime", ActiveTransform::end_time}});
    const Token which = r.lexer.next();
    if (which.kind != TokenKind::word) {
        throw SceneError(which.place, describe(which), "All, StartTime or EndTime after ActiveTransform");
    }
    r.scene.active_transform(supported_row<Which>(which.place, {"transformation"}, which.text, kWhich).active);
}
/// Without effect, as nothing moves.
void run_transform_times(Reading& r) { read_numbers<2>(r.lexer); }
/// The medium inside, and maybe that outside.
void run_medium_interface(Reading& r) {
    Token name = read_string(r.lexer, r.directive);
    r.scene.medium_interface(name.place, string_value(name));
    if (r.lexer.peek().kind != TokenKind::string) return;
    name = r.lexer.next();
    r.scene.medium_interface(name.place, string_value(name));
}
void run_option(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    const bool brackets = r.lexer.peek().kind == TokenKind::open_bracket;
    if (brackets) r.lexer.next();
    r.scene.option(name, r.lexer.next());
    if (!brackets) return;
    const Token close = r.lexer.next();
    if (close.kind != TokenKind::close_bracket)
        throw SceneError(close.place, describe(close), "a \"]\" after one value");
}
void run_include(Reading& r) { r.texts.open(read_string(r.lexer, r.directive), TextKind::included, r.scene.files()); }
void run_import(Reading& r) {
    r.texts.open(read_string(r.lexer, r.directive), TextKind::imported, r.scene.files());
    r.scene.import_begin();
}

void run_texture(Reading& r) {
    const Token name = read_string(r.lexer, r.directive), kind = read_string(r.lexer, r.directive);
    const Token texture_class = read_string(r.lexer, r.directive);
    r.scene.texture({string_value(name), string_value(kind), name.place, kind.place}, read_list(r, texture_class));
}

/// Directives of a name and parameters.
template <auto Apply>
void run_named(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    (r.scene.*Apply)(r.directive.place, read_list(r, name));
}

enum class Where { anywhere, options, world };

struct Directive {
    std::string_view name;
    void (*run)(Reading&) = nullptr;
    Where where = Where::anywhere;
    Support support = Support::here;
    std::string_view advice = {};
};

using enum Where;
constexpr auto kDirectives = std::to_array<Directive>({
    {"Accelerator", run_named<&SceneBuilder::accelerator>, options},
    {"ActiveTransform", run_active_transform, anywhere},
    {"AreaLightSource", run_named<&SceneBuilder::area_light_source>, world},
    {"Attribute", run_named<&SceneBuilder::attribute>, anywhere},
    {"AttributeBegin", run_attribute_begin, world},
    {"AttributeEnd", run_attribute_end, world},
    {"Camera", run_named<&SceneBuilder::camera>, options},
    {"ColorSpace", run_color_space, anywhere},
    {"ConcatTransform", run_concat_transform, anywhere},
    {"CoordSysTransform", run_coord_sys_transform, anywhere},
    {"CoordinateSystem", run_coordinate_system, anywhere},
    {"Film", run_named<&SceneBuilder::film>, options},
    {"Identity", run_identity, anywhere},
    {"Import", run_import, world},
    {"Include", run_include, anywhere},
    {"Integrator", run_named<&SceneBuilder::integrator>, options},
    {"LightSource", run_named<&SceneBuilder::light_source>, world},
    {"LookAt", run_look_at, anywhere},
    {"MakeNamedMaterial", run_named<&SceneBuilder::make_named_material>, world},
    {"Material", run_named<&SceneBuilder::material>, world},
    {"MediumInterface", run_medium_interface, anywhere},
    {"NamedMaterial", run_named_material, world},
    {"ObjectBegin", run_object_begin, world},
    {"ObjectEnd", run_object_end, world},
    {"ObjectInstance", run_object_instance, world},
    {"Option", run_option, anywhere},
    {"PixelFilter", run_named<&SceneBuilder::pixel_filter>, options},
    {"ReverseOrientation", run_reverse_orientation, world},
    {"Rotate", run_rotate, anywhere},
    {"Sampler", run_named<&SceneBuilder::sampler>, options},
    {"Scale", run_scale, anywhere},
    {"Shape", run_named<&SceneBuilder::shape>, world},
    {"Texture", run_texture, world},
    {"Transform", run_transform, anywhere},
    {"TransformBegin", run_transform_begin, world},
    {"TransformEnd", run_transform_end, world},
    {"TransformTimes", run_transform_times, options},
    {"Translate", run_translate, anywhere},
    {"WorldBegin", run_world_begin, options},
    {.name = "MakeNamedMedium", .support = Support::pbrt_only, .advice = "there are no media here"},
});

void check_block(const Token& token, const Directive& directive, SceneBlock block) {
    if (directive.where == options && block == SceneBlock::world) {
        throw SceneError(token.place, fmt::format("{} after WorldBegin", directive.name), "it before, and only there");
    }
    if (directive.where == world && block == SceneBlock::options) {
        throw SceneError(token.place, fmt::format("{} before WorldBegin", directive.name), "it after, and only there");
    }
}

}  // namespace

Scene read_scene(const std::filesystem::path& path) { return parse_scene(read_text_file(path), path); }

Scene parse_scene(std::string_view text, const std::filesystem::path& name) {
    SceneTexts texts(name, text);
    SceneBuilder builder(name.parent_path());
    while (true) {
        if (texts.lexer().peek().kind == TokenKind::end) {
            const TextKind closed = texts.close();
            if (closed == TextKind::main) break;
            if (closed == TextKind::imported) builder.import_end();
            continue;
        }
        Reading reading{texts.lexer(), builder, texts, texts.lexer().next()};
        const Token& token = reading.directive;
        if (token.kind != TokenKind::word) throw SceneError(token.place, describe(token), "a directive");
        const auto& directive = supported_row<Directive>(token.place, {"directive"}, token.text, kDirectives);
        check_block(token, directive, builder.block());
        directive.run(reading);
    }
    Scene scene = builder.finish(texts.lexer().peek().place);
    ContentHash hash;
    hash.add(text);
    hash.add(builder.files().hash());
    scene.hash = hash.hex();
    scene.files = builder.files().list();
    return scene;
}

}  // namespace emulsion
