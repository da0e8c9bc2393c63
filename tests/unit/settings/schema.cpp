// The schema and the reference say what the reader does.
#include <functional>

#include "settings/cloudscape_json.h"
#include "settings/described_schema.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json schema_at(const std::string& pointer) { return json::parse(cloudscape_schema()).at(json::json_pointer(pointer)); }

TEST(Schema, IsOfThe2020DraftAndClosed) {
  const json schema = schema_at("");
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_NE(schema["$id"], "");
  EXPECT_EQ(schema["title"], "Cloudscape document");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema_at("/properties/medium/properties/phase")["additionalProperties"], false);
}

TEST(Schema, SaysTypesRangesAndDefaults) {
  const json albedo = schema_at("/properties/medium/properties/single_scattering_albedo");
  EXPECT_EQ(albedo, (json{{"type", "number"},
                          {"minimum", 0},
                          {"maximum", 1},
                          {"default", 1.0},
                          {"description", "Scattering over extinction."}}));
  EXPECT_EQ(schema_at("/properties/volume/properties/resolution/enum"), (json{16, 32, 64, 128, 256, 512}));
  EXPECT_EQ(schema_at("/properties/sky/properties/kind/enum"), (json{"none", "uniform", "clear"}));
  EXPECT_EQ(schema_at("/properties/shape/properties/threshold/type"), (json{"number", "null"}));
  EXPECT_EQ(schema_at("/properties/shape/properties/towers/maxItems"), 32);
  EXPECT_EQ(schema_at("/properties/shape/properties/towers/items/properties/center/items/maximum"), 1);
  const json channels = schema_at("/properties/noise/properties/channels");
  EXPECT_EQ(channels["minItems"], 4);
  EXPECT_EQ(channels["maxItems"], 4);
  EXPECT_EQ(channels["items"]["type"], "object");
  EXPECT_FALSE(channels["items"]["properties"]["frequency"].contains("default")) << "each channel has its own";
  EXPECT_EQ(channels["default"][3]["frequency"], Noise{}.channels[3].frequency);
  EXPECT_EQ(schema_at("/properties/title/maxLength"), 80);
}

// Every number that the schema bounds: its bounds are read, what lies beyond is refused with the schema's numbers.
TEST(Schema, BoundsAreTheReaders) {
  int bounds = 0;
  const std::function<void(const json&, const std::string&, const std::string&)> walk =
      [&](const json& schema, const std::string& before, const std::string& after) {
        if (schema.contains("properties")) {
          for (const auto& [key, inner] : schema["properties"].items())
            walk(inner, before + "{\"" + key + "\":", "}" + after);
        } else if (schema.contains("maximum") && !schema.contains("enum")) {
          const auto refused = [&](const json& value) {
            return refusal([&] { parse_cloudscape(before + value.dump() + after, "text"); }).sentence;
          };
          const double min = schema["minimum"], max = schema["maximum"];
          EXPECT_THAT(refused(max + 1), HasSubstr("must be within [")) << before;
          EXPECT_THAT(refused(min - 1), HasSubstr("must be within [")) << before;
          EXPECT_THAT(refused(max), testing::Not(HasSubstr("must be within"))) << before;
          EXPECT_THAT(refused(min), testing::Not(HasSubstr("must be within"))) << before;
          ++bounds;
        }
      };
  walk(schema_at(""), "", "");
  EXPECT_GT(bounds, 35);
}

TEST(Reference, HasARowForEveryKey) {
  const std::string text = cloudscape_reference();
  for (const char* row : {
           "| `single_scattering_albedo` | number in [0, 1] | `1.0` | Scattering over extinction. |",
           "| `kind` | one of none, uniform, clear | `\"clear\"` |",
           "| `threshold` | number in [0, 2] or null | `null` |",
           "| `irradiance` | array of 3: each number in [0, 1000000] | `[1.983,1.774,1.74]` |",
           "| `resolution` | one of 16, 32, 64, 128, 256, 512 | `128` |",
       })
    EXPECT_THAT(text, HasSubstr(row));
  EXPECT_THAT(text, HasSubstr("Default of `channels`:\n\n```json\n[{\"worley_mix\":0.7,\"frequency\":4,"));
  for (const char* heading : {"### document\n", "### medium\n", "### medium.phase\n", "### noise.channels\n",
                              "### shape.towers\n", "### view.pose\n"})
    EXPECT_THAT(text, HasSubstr(heading));
}

}  // namespace
}  // namespace cloudscape::settings
