#include "pathtracer/scene_parser.h"

#include <array>

#include <fmt/format.h>

#include "core/content_hash.h"
#include "core/text_file.h"
#include "pathtracer/scene_builder.h"
#include "pathtracer/scene_lexer.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

// --- What follows a directive

/// What a directive acts on.
struct Reading {
    Lexer& lexer;
    SceneBuilder& scene;
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
void run_named_material(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    r.scene.named_material(name.place, string_value(name));
}

void run_texture(Reading& r) {
    const Token name = read_string(r.lexer, r.directive), kind = read_string(r.lexer, r.directive);
    const Token texture_class = read_string(r.lexer, r.directive);
    r.scene.texture({string_value(name), string_value(kind), name.place, kind.place},
                    {string_value(texture_class), texture_class.place, read_parameters(r.lexer)});
}

/// Directives of a name and parameters.
template <auto Apply>
void run_named(Reading& r) {
    const Token name = read_string(r.lexer, r.directive);
    (r.scene.*Apply)(r.directive.place, {string_value(name), name.place, read_parameters(r.lexer)});
}

enum class Where { anywhere, options, world };

struct Directive {
    std::string_view name;
    void (*run)(Reading&) = nullptr;
    Where where = Where::anywhere;
    Support support = Support::here;
};

using enum Where;
constexpr auto kDirectives = std::to_array<Directive>({
    {"AreaLightSource", run_named<&SceneBuilder::area_light_source>, world},
    {"AttributeBegin", run_attribute_begin, world},
    {"AttributeEnd", run_attribute_end, world},
    {"Camera", run_named<&SceneBuilder::camera>, options},
    {"ConcatTransform", run_concat_transform, anywhere},
    {"Film", run_named<&SceneBuilder::film>, options},
    {"Identity", run_identity, anywhere},
    {"Integrator", run_named<&SceneBuilder::integrator>, options},
    {"LightSource", run_named<&SceneBuilder::light_source>, world},
    {"LookAt", run_look_at, anywhere},
    {"MakeNamedMaterial", run_named<&SceneBuilder::make_named_material>, world},
    {"Material", run_named<&SceneBuilder::material>, world},
    {"NamedMaterial", run_named_material, world},
    {"PixelFilter", run_named<&SceneBuilder::pixel_filter>, options},
    {"ReverseOrientation", run_reverse_orientation, world},
    {"Rotate", run_rotate, anywhere},
    {"Sampler", run_named<&SceneBuilder::sampler>, options},
    {"Scale", run_scale, anywhere},
    {"Shape", run_named<&SceneBuilder::shape>, world},
    {"Texture", run_texture, world},
    {"Transform", run_transform, anywhere},
    {"Translate", run_translate, anywhere},
    {"WorldBegin", run_world_begin, options},
    {.name = "Accelerator", .support = Support::pbrt_only},
    {.name = "ActiveTransform", .support = Support::pbrt_only},
    {.name = "Attribute", .support = Support::pbrt_only},
    {.name = "ColorSpace", .support = Support::pbrt_only},
    {.name = "CoordinateSystem", .support = Support::pbrt_only},
    {.name = "CoordSysTransform", .support = Support::pbrt_only},
    {.name = "Import", .support = Support::pbrt_only},
    {.name = "Include", .support = Support::pbrt_only},
    {.name = "MakeNamedMedium", .support = Support::pbrt_only},
    {.name = "MediumInterface", .support = Support::pbrt_only},
    {.name = "ObjectBegin", .support = Support::pbrt_only},
    {.name = "ObjectEnd", .support = Support::pbrt_only},
    {.name = "ObjectInstance", .support = Support::pbrt_only},
    {.name = "Option", .support = Support::pbrt_only},
    {.name = "TransformBegin", .support = Support::pbrt_only},
    {.name = "TransformEnd", .support = Support::pbrt_only},
    {.name = "TransformTimes", .support = Support::pbrt_only},
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
    const SourceText source{name, text};
    Lexer lexer(source);
    SceneBuilder builder(name.parent_path());
    while (lexer.peek().kind != TokenKind::end) {
        Reading reading{lexer, builder, lexer.next()};
        const Token& token = reading.directive;
        if (token.kind != TokenKind::word) throw SceneError(token.place, describe(token), "a directive");
        const auto& directive = supported_row<Directive>(token.place, {"directive"}, token.text, kDirectives);
        check_block(token, directive, builder.block());
        directive.run(reading);
    }
    Scene scene = builder.finish(lexer.peek().place);
    ContentHash hash;
    hash.add(text);
    hash.add(builder.files().hash());
    scene.hash = hash.hex();
    scene.files = builder.files().list();
    return scene;
}

}  // namespace emulsion
