// Tests height pictures. Every kind of PNG must give the same depths, and a file that is not a picture must give an
// error message of one sentence. The test writes the pictures itself, chunk by chunk.
#include "worlds/readers/height_picture.h"

#include <functional>
#include <random>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace height_picture_test {

void add_number(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
}

void add_chunk(std::string& out, const std::string& type, const std::string& data) {
    add_number(out, static_cast<std::uint32_t>(data.size()));
    const std::string body = type + data;
    std::uint32_t crc = 0xffffffffU;
    for (const char c : body) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320U ^ crc >> 1 : crc >> 1;
    }
    out += body;
    add_number(out, ~crc);
}

// Returns a zlib stream of stored blocks, without compression.
std::string stored(const std::string& raw) {
    std::string out = "\x78\x01";
    for (std::size_t at = 0; at < raw.size() || at == 0; at += 65535) {
        const std::size_t length = std::min<std::size_t>(65535, raw.size() - at);
        out += static_cast<char>(at + length >= raw.size());
        for (const std::size_t n : {length, ~length})
            for (int shift = 0; shift < 16; shift += 8) out += static_cast<char>(n >> shift & 0xff);
        out += raw.substr(at, length);
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : raw) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    add_number(out, b << 16 | a);
    return out;
}

struct Kind {
    // Colour type of PNG: 0 grey, 2 colour, 3 palette, 4 grey and alpha, 6 colour and alpha.
    int colour_type, bits, channels;
    bool interlaced;
};

using Samples = std::function<std::uint32_t(int x, int y, int channel)>;

std::string png(int width, int height, const Kind& kind, const Samples& sample, const std::string& palette = {},
                const std::string& transparency = {}) {
    std::string raw;
    const auto add_pass = [&](int x0, int y0, int dx, int dy) {
        for (int y = y0; y < height; y += dy) {
            if (x0 >= width) break;
            raw += '\0';
            int filled = 0;
            unsigned byte = 0;
            for (int x = x0; x < width; x += dx)
                for (int c = 0; c < kind.channels; ++c) {
                    const std::uint32_t value = sample(x, y, c);
                    if (kind.bits == 16) raw += static_cast<char>(value >> 8 & 0xff);
                    if (kind.bits >= 8) {
                        raw += static_cast<char>(value & 0xff);
                        continue;
                    }
                    byte = byte << kind.bits | value;
                    if ((filled += kind.bits) == 8) {
                        raw += static_cast<char>(byte);
                        filled = 0;
                        byte = 0;
                    }
                }
            if (filled > 0) raw += static_cast<char>(byte << (8 - filled));
        }
    };
    if (kind.interlaced) {
        constexpr int kPasses[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                       {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
        for (const auto& p : kPasses) add_pass(p[0], p[1], p[2], p[3]);
    } else {
        add_pass(0, 0, 1, 1);
    }
    std::string out = "\x89PNG\r\n\x1a\n", header;
    add_number(header, static_cast<std::uint32_t>(width));
    add_number(header, static_cast<std::uint32_t>(height));
    header +=
        {static_cast<char>(kind.bits), static_cast<char>(kind.colour_type), 0, 0, static_cast<char>(kind.interlaced)};
    add_chunk(out, "IHDR", header);
    if (!palette.empty()) add_chunk(out, "PLTE", palette);
    if (!transparency.empty()) add_chunk(out, "tRNS", transparency);
    add_chunk(out, "IDAT", stored(raw));
    add_chunk(out, "IEND", "");
    return out;
}

// The content of all pictures below: values from 0 to 1 in steps that every bit depth can represent.
constexpr int kWidth = 13, kHeight = 9;
double shown(int x, int y, int bits) {
    const int steps = bits == 1 ? 1 : 3;
    return static_cast<double>((x + 2 * y) % (steps + 1)) / steps;
}

void expect_shown(const std::string& bytes, int bits, const char* what) {
    const Result<HeightPicture> picture = read_height_picture(bytes, "p.png");
    ASSERT_TRUE(picture.has_value()) << what << ": " << picture.error().message;
    ASSERT_EQ(picture->width, kWidth);
    ASSERT_EQ(picture->height, kHeight);
    ASSERT_EQ(picture->depths.size(), static_cast<std::size_t>(kWidth * kHeight));
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            EXPECT_NEAR(static_cast<double>(picture->depths[static_cast<std::size_t>(y * kWidth + x)]),
                        shown(x, y, bits), 1e-6)
                << what << " " << x << " " << y;
}

TEST(HeightPicture, reads_grey_of_every_bit_depth_plain_and_interlaced) {
    for (const bool interlaced : {false, true})
        for (const int bits : {1, 2, 4, 8, 16}) {
            const Samples sample = [&](int x, int y, int) {
                return static_cast<std::uint32_t>(std::lround(shown(x, y, bits) * ((1 << bits) - 1)));
            };
            expect_shown(png(kWidth, kHeight, {0, bits, 1, interlaced}, sample), bits,
                         interlaced ? "interlaced" : "straight");
        }
}

TEST(HeightPicture, uses_the_blue_channel_of_colour_and_palette_images) {
    for (const bool interlaced : {false, true})
        for (const int bits : {8, 16}) {
            const Samples sample = [&](int x, int y, int channel) {
                return static_cast<std::uint32_t>(channel == 2 ? std::lround(shown(x, y, bits) * ((1 << bits) - 1))
                                                               : 77 * channel + 5);
            };
            expect_shown(png(kWidth, kHeight, {2, bits, 3, interlaced}, sample), bits, "colour");
        }
    for (const int bits : {2, 4, 8}) {
        // Four colours with blue 0, 1/3, 2/3, 1.
        const std::string palette("\xff\x01\x00\x02\xff\x55\x80\x80\xaa\x00\x00\xff", 12);
        expect_shown(
            png(
                kWidth, kHeight, {3, bits, 1, bits == 4},
                [&](int x, int y, int) { return static_cast<std::uint32_t>(std::lround(3 * shown(x, y, bits))); },
                palette),
            bits, "palette");
    }
}

TEST(HeightPicture, uses_the_opacity_of_images_with_an_alpha_channel) {
    for (const int bits : {8, 16})
        for (const int channels : {2, 4}) {
            const std::uint32_t full = (1U << bits) - 1;
            // The colour is white everywhere, so only the opacity contains the picture.
            const Samples sample = [&](int x, int y, int channel) {
                return channel == channels - 1 ? static_cast<std::uint32_t>(std::lround(shown(x, y, bits) * full))
                                               : full;
            };
            expect_shown(png(kWidth, kHeight, {channels == 2 ? 4 : 6, bits, channels, false}, sample), bits, "alpha");
        }
    const std::string palette("\x00\x00\xff\x00\x00\xff", 6), transparency("\x00\xff", 2);
    expect_shown(png(
                     kWidth, kHeight, {3, 1, 1, false},
                     [](int x, int y, int) { return static_cast<std::uint32_t>(std::lround(shown(x, y, 1))); }, palette,
                     transparency),
                 1, "transparent palette");
}

std::string small_png(bool interlaced = false) {
    return png(kWidth, kHeight, {2, 8, 3, interlaced},
               [](int x, int y, int c) { return static_cast<std::uint32_t>((37 * x + 11 * y + c) % 256); });
}

TEST(HeightPicture, survives_being_cut_at_every_byte) {
    for (const bool interlaced : {false, true}) {
        const std::string whole = small_png(interlaced);
        ASSERT_TRUE(read_height_picture(whole, "p.png"));
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Result<HeightPicture> picture =
                read_height_picture(std::string_view(whole).substr(0, length), "p.png");
            ASSERT_FALSE(picture.has_value()) << length;
            EXPECT_TRUE(picture.error().message.ends_with(".")) << picture.error().message;
        }
    }
}

TEST(HeightPicture, survives_random_damage) {
    for (unsigned seed = 1; seed <= static_cast<unsigned>(test::scaled(3000)); ++seed) {
        std::mt19937 random(seed);
        std::string bytes = small_png(seed % 2 == 0);
        for (std::uint32_t edits = 1 + random() % 4; edits > 0; --edits)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        const Result<HeightPicture> picture = read_height_picture(bytes, "p.png");
        if (picture) {
            ASSERT_EQ(picture->depths.size(),
                      static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height))
                << "seed " << seed;
            for (const float depth : picture->depths) ASSERT_TRUE(depth >= 0.0F && depth <= 1.0F) << "seed " << seed;
        }
    }
}

TEST(HeightPicture, names_the_reason_for_refusing_a_file_that_is_too_large_or_not_a_png) {
    const auto message = [](const std::string& bytes) {
        const auto picture = read_height_picture(bytes, "p.png");
        return picture ? std::string("read") : picture.error().message;
    };
    EXPECT_EQ(message("GIF89a"), "This is not a PNG picture.");
    EXPECT_EQ(message(""), "This is not a PNG picture.");
    const Samples black = [](int, int, int) { return 0U; };
    EXPECT_EQ(message(png(4097, 1, {0, 1, 1, false}, black)),
              "This picture is more than 4096 pixels wide or high. Make it smaller.");
    EXPECT_EQ(message(png(1, 4097, {0, 1, 1, false}, black)),
              "This picture is more than 4096 pixels wide or high. Make it smaller.");
    EXPECT_EQ(message(png(4096, 1, {0, 1, 1, false}, black)), "read");
}

// ---- keys of a map for height pictures ----

std::string panel(const std::string& keys) {
    return test::entity("worldspawn", {}, test::box_brush(0, 0, -8, 64, 64, 0)) +
           test::entity("func_wall", test::key("name", "panel") + keys, test::box_brush(0, 0, 0, 32, 4, 16));
}

const Material& material_of_panel(const Scene& scene) {
    for (const Solid& solid : scene.solids)
        if (solid.feature && scene.features[solid.feature.value].name == "panel")
            return scene.material(solid.face_materials.front());
    return scene.materials.front();
}

TEST(TextureKeys, are_read_with_their_units_and_defaults) {
    const auto scene = read_quake_map(
        panel(test::key("texture_wave", "square") + test::key("texture_period", "8") +
              test::key("texture_depth", "0.5") + test::key("friction_wave", "0.2") + test::key("texture_angle", "90") +
              test::key("damping", "6") + test::key("friction", "0.4") + test::key("friction_static", "0.5")),
        "t.map");
    ASSERT_TRUE(scene.has_value());
    EXPECT_EQ(scene->report.warnings_in_all, 0);
    const Material& material = material_of_panel(*scene);
    EXPECT_EQ(material.damping_ns_per_m, 6.0);
    EXPECT_EQ(material.friction_mu, 0.4);
    EXPECT_EQ(material.friction_static, 0.5);
    ASSERT_TRUE(material.wave.has_value());
    EXPECT_EQ(material.wave->shape, WaveShape::Square);
    EXPECT_EQ(material.wave->period_hand_m, 8e-3);
    EXPECT_EQ(material.wave->depth_hand_m, 0.5 * 1e-3);
    EXPECT_EQ(material.wave->friction_share, 0.2);
    EXPECT_NEAR(material.wave->turn_rad, 0.5 * kPi, 1e-12);
    const auto plain = read_quake_map(panel(test::key("texture_wave", "sine")), "t.map");
    ASSERT_TRUE(plain.has_value());
    EXPECT_EQ(material_of_panel(*plain).wave->period_hand_m, 10.0 * 1e-3);
    EXPECT_EQ(material_of_panel(*plain).wave->depth_hand_m, 0.4 * 1e-3);
    EXPECT_FALSE(material_of_panel(*plain).friction_static.has_value());
}

TEST(TextureKeys, that_are_out_of_range_or_unknown_are_reported_and_the_nearest_value_is_used) {
    struct Wrong {
        std::string keys, part;
    };
    for (const Wrong& wrong :
         {Wrong{test::key("texture_wave", "zigzag"), "zigzag"},
          Wrong{test::key("texture_depth", "9"), "0 to 5 millimetres"},
          Wrong{test::key("texture_period", "0"), "1 to 100"}, Wrong{test::key("friction_wave", "2"), "0 to 0.3"},
          Wrong{test::key("damping", "-1"), "0 to 10"}, Wrong{test::key("damping", "nan"), "is not a number"},
          Wrong{test::key("friction", "0.5") + test::key("friction_static", "0.4"),
                "lower than that of the key friction"},
          Wrong{test::key("friction", "0.4") + test::key("friction_static", "0.6"), "1.25"}}) {
        const auto scene = read_quake_map(panel(wrong.keys), "t.map");
        ASSERT_TRUE(scene.has_value());
        ASSERT_EQ(scene->report.warnings_in_all, 1) << wrong.part;
        EXPECT_NE(scene->report.warnings[0].message.find(wrong.part), std::string::npos)
            << scene->report.warnings[0].message;
        EXPECT_GT(scene->report.warnings[0].line, 0);
    }
}

TEST(TextureKeys, load_a_picture_next_to_the_map_and_leave_the_surface_plain_if_it_is_unusable) {
    const test::TemporaryFolder folder;
    folder.write("good.png", small_png());
    folder.write("bad.png", small_png().substr(0, 100));
    const auto read = [&](const std::string& name) {
        return read_world(
            folder.write("p.map", panel(test::key("texture_picture", name) + test::key("texture_depth", "1.5"))));
    };
    const auto good = read("good.png");
    ASSERT_TRUE(good.has_value());
    EXPECT_EQ(good->report.warnings_in_all, 0);
    const Material& material = material_of_panel(*good);
    ASSERT_TRUE(material.picture.has_value());
    EXPECT_EQ(material.picture->depth_hand_m, 1.5 * 1e-3);
    EXPECT_EQ(material.picture->size_m, 1.0);  // 32 units: the longer side of the panel
    EXPECT_EQ(material.picture->box_m.min_m, Vec3(0.0));
    EXPECT_EQ(material.picture->heights->width, kWidth);
    for (const std::string name : {"missing.png", "bad.png", "p.map", "../good.png", "/etc/hostname"}) {
        const auto scene = read(name);
        ASSERT_TRUE(scene.has_value()) << name;
        EXPECT_FALSE(material_of_panel(*scene).picture.has_value()) << name;
        ASSERT_EQ(scene->report.warnings_in_all, 1) << name;
        EXPECT_EQ(scene->report.warnings[0].action, "The surface stays plain.");
        EXPECT_GT(scene->report.warnings[0].line, 0);
    }
}

}  // namespace height_picture_test
}  // namespace handrail
