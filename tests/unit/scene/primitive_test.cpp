// Tests exact shapes in a scene: which values they refuse, and how closely the flat faces around them fit.
#include "worlds/scene/primitive.h"

#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace primitive_test {

Rotation some_rotation(std::mt19937& random) {
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    const double w = u(random), x = u(random), y = u(random), z = u(random);
    return normalized({w, x, y, z});
}

TEST(Primitive, refuses_invalid_sizes_and_shape_changing_stretches_with_a_sentence) {
    const auto refused = [](PrimitiveKind kind, const Vec3& size, const Vec3& stretch = Vec3(1.0), double scale = 1.0) {
        const Result<Solid> solid = make_solid({kind, size, stretch, {{1, 2, 3}, {}, scale}});
        EXPECT_TRUE(solid || solid.error().message.ends_with('.')) << solid.error().message;
        return !solid;
    };
    for (int k = 0; k < 5; ++k) {
        const auto kind = static_cast<PrimitiveKind>(k);
        EXPECT_FALSE(refused(kind, Vec3(0.5))) << k;
        EXPECT_FALSE(refused(kind, Vec3(0.5), Vec3(1.0), 3.0));
        for (const double bad :
             {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            EXPECT_TRUE(refused(kind, {0.5, 0.5, bad}));
            EXPECT_TRUE(refused(kind, Vec3(0.5), {bad, 1.0, 1.0}));
            EXPECT_TRUE(refused(kind, Vec3(0.5), Vec3(1.0), bad));
        }
        EXPECT_EQ(refused(kind, {0.5, 0.6, 0.9}), kind != PrimitiveKind::Box);
        EXPECT_EQ(refused(kind, Vec3(0.5), {1.0, 1.0, 2.0}), kind == PrimitiveKind::Sphere);
        EXPECT_EQ(refused(kind, Vec3(0.5), {2.0, 1.0, 1.0}), kind != PrimitiveKind::Box);
        EXPECT_EQ(refused(kind, Vec3(0.5), {1.0, 1.0, 0.5}),
                  kind == PrimitiveKind::Sphere || kind == PrimitiveKind::Capsule);
    }
}

TEST(Primitive, is_inside_its_drawn_flat_faces_and_fills_them) {
    constexpr std::uint32_t kSeed = 11;
    std::mt19937 random(kSeed);
    for (int round = 0; round < test::scaled(60); ++round) {
        const auto kind = static_cast<PrimitiveKind>(round % 5);
        const double wide = 0.01 + (random() % 1000) / 500.0,
                     high = kind == PrimitiveKind::Sphere ? wide : wide * (1.0 + (random() % 100) / 50.0);
        const Primitive primitive{
            kind, {wide, wide, high}, Vec3(1.0), {{5, -3, 2}, some_rotation(random), 0.5 + (random() % 10) / 5.0}};
        const Result<Solid> solid = make_solid(primitive);
        ASSERT_TRUE(solid) << solid.error().message;
        ASSERT_EQ(solid->shape.planes.size(), solid->shape.faces.size());
        EXPECT_EQ(std::holds_alternative<std::monostate>(solid->round), kind == PrimitiveKind::Box);
        if (kind == PrimitiveKind::Box) continue;
        const double reach = 0.5 * wide * primitive.at.scale;
        for (std::size_t face = 0; face < solid->shape.planes.size(); ++face) {
            const Plane& plane = solid->shape.planes[face];
            EXPECT_NEAR(glm::length(plane.normal), 1.0, 1e-12);
            // Seen from far away along the normal of a face, the exact shape must begin at that face.
            const Vec3 far = solid->shape.bounds_m.centre_m() + plane.normal * 1e3;
            const ClosestPoint q = std::visit(
                [&](const auto& shape) {
                    if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, std::monostate>) return ClosestPoint{};
                    else return closest_point(shape, far);
                },
                solid->round);
            EXPECT_LE(signed_distance(plane, q.point_m), 1e-9 * wide) << "seed " << kSeed << " round " << round;
            EXPECT_GE(signed_distance(plane, q.point_m), -0.01 * reach);
            const double wider = kind == PrimitiveKind::Sphere || kind == PrimitiveKind::Capsule ? 0.042
                                 : kind == PrimitiveKind::Cylinder                               ? 0.01
                                                                                                 : 0.03;
            for (const Vec3& corner : solid->shape.faces[face].points_m) {
                const double out = signed_distance(solid->round, corner);
                EXPECT_GE(out, -1e-9 * wide);
                EXPECT_LE(out, wider * reach) << static_cast<int>(kind);
            }
        }
    }
}

TEST(Primitive, makes_a_model_that_can_be_placed) {
    for (int k = 0; k < 5; ++k) {
        const auto model = primitive_model({static_cast<PrimitiveKind>(k), Vec3(1.0), Vec3(1.0), {}});
        ASSERT_TRUE(model) << k;
        const Result<void> valid = validate(**model);
        EXPECT_TRUE(valid) << valid.error().message;
        EXPECT_EQ((*model)->features.at(0).name, kPrimitiveNames[static_cast<std::size_t>(k)]);
    }
    EXPECT_FALSE(primitive_model({PrimitiveKind::Cone, Vec3(0.0), Vec3(1.0), {}}));
}

}  // namespace primitive_test
}  // namespace handrail
