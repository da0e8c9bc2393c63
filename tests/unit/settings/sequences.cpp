// Sequences: which frames, what each of them shows, the names of their files, and what is refused.
#include "settings/frame_pattern.h"
#include "settings/sequence_request.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;

class Sequences : public testing::Test {
 protected:
  static std::string body(const std::string& members) {
    return R"({"cloudscape": "overcast", "path": "fly-around")" + (members.empty() ? "" : ", " + members) + "}";
  }
  SequenceRequest read(const std::string& members, const SequenceLimits& limits = {}) const {
    return sequence_from_json(body(members), library, limits);
  }
  template <class Failure = InvalidInput>
  Refusal refused(const std::string& members, const SequenceLimits& limits = {}) const {
    return refusal<Failure>([&] { read(members, limits); });
  }
  CloudscapeLibrary library{{}};
};

TEST_F(Sequences, WholePathIsTheDefault) {
  const SequenceRequest sequence = read("");
  EXPECT_EQ(sequence.range.first, 0);
  EXPECT_EQ(sequence.range.last, 600) << "20 s at 30 frames a second, both ends";
  EXPECT_EQ(sequence.frames(), 601);
  EXPECT_EQ(sequence.container, ContainerKind::zip);
}

TEST_F(Sequences, FrameIsThePathAtItsTime) {
  const SequenceRequest sequence = read(R"("frames": {"first": 3, "last": 40, "frames_per_second": 10},
      "image": {"width": 64, "height": 48, "quality": "draft", "time_s": 100, "format": "png"}, "container": "zip")");
  const CameraPath path = named_camera_path("fly-around");
  const FrameRequest frame = sequence.frame(33);
  EXPECT_EQ(frame.pose, at(path, 3.3));
  EXPECT_EQ(frame.lens.vertical_fov_deg, key_at(path, 3.3).vertical_fov_deg);
  EXPECT_EQ(frame.time_s, 103.3) << "the wind blows along";
  EXPECT_EQ(frame.size_px, (ImageSize{64, 48}));
  EXPECT_EQ(sequence.still.encoding.format, ImageFormat::png);
  EXPECT_EQ(sequence.frame(40).pose, path.keys[1].pose);
}

TEST_F(Sequences, PathsComeByNameOrWhole) {
  const auto sequence = sequence_from_json(
      R"({"cloudscape": "overcast", "path": {"keys": [{"time_s": 0}, {"time_s": 2, "vertical_fov_deg": 80}]}})",
      library, {});
  EXPECT_EQ(sequence.frames(), 61);
  EXPECT_EQ(sequence.frame(60).lens.vertical_fov_deg, 80);
  const auto wrong = [&](const std::string& path) {
    return refusal([&] { sequence_from_json(R"({"cloudscape": "overcast", "path": )" + path + "}", library, {}); });
  };
  EXPECT_EQ(wrong(R"({"keys": [{"time_s": 0}, {"time_s": 0}]})").pointer, "/path/keys/1/time_s");
  EXPECT_THAT(wrong(R"({"keys": [{"time_s": 0}, {"time_s": 0}]})").sentence,
              HasSubstr("/path/keys/1/time_s is 0: must be more"));
  EXPECT_EQ(wrong("{}").pointer, "/path/keys");
  EXPECT_EQ(wrong("7").pointer, "/path");
  EXPECT_EQ(refusal([&] { sequence_from_json(R"({"cloudscape": "overcast"})", library, {}); }).pointer, "/path");
  EXPECT_THAT(refusal<NotFound>([&] {
                sequence_from_json(R"({"cloudscape": "overcast", "path": "fly-arund"})", library, {});
              }).sentence,
              HasSubstr("did you mean fly-around?"));
}

TEST_F(Sequences, WhatIsWrongIsNamed) {
  EXPECT_EQ(refused(R"("frames": {"first": 601})").pointer, "/frames");
  EXPECT_EQ(refused(R"("frames": {"first": 5, "last": 4})").pointer, "/frames");
  EXPECT_THAT(refused(R"("frames": {"last": 601})").sentence, HasSubstr("20 s end with frame 600"));
  EXPECT_EQ(refused(R"("frames": {"first": -1})").pointer, "/frames/first");
  EXPECT_EQ(refused(R"("frames": {"frames_per_second": 0})").pointer, "/frames/frames_per_second");
  EXPECT_EQ(refused(R"("frames": 7)").pointer, "/frames");
  EXPECT_EQ(refused(R"("container": "tar")").pointer, "/container");
  EXPECT_EQ(refused(R"("container": "avi", "image": {"format": "exr"})").pointer, "/container");
  EXPECT_EQ(refused(R"("camera": {"azimuth_deg": 3})").pointer, "/camera/azimuth_deg");
  EXPECT_EQ(refused(R"("camera": {"lens": {"vertical_fov_deg": 3}})").pointer, "/camera/lens/vertical_fov_deg");
  EXPECT_EQ(refused(R"("wdth": 3)").pointer, "/wdth");
  EXPECT_EQ(refused(R"("image": {"width": 0})").pointer, "/image/width");
  EXPECT_EQ(refusal([&] { sequence_from_json("[1]", library, {}); }).sentence,
            "the document is [1]: must be an object");
}

TEST_F(Sequences, LimitsHoldForEachFrameAndForAll) {
  SequenceLimits limits;
  EXPECT_EQ(read(R"("frames": {"frames_per_second": 89})", limits).frames(), 1781);
  EXPECT_THAT(refused<OverLimit>(R"("frames": {"frames_per_second": 90})", limits).sentence,
              HasSubstr("1801: this server's limit is 1800"));
  EXPECT_EQ(refused<OverLimit>(R"("image": {"width": 5000})", limits).pointer, "/image/width");
  limits.max_gigasteps = 1;
  EXPECT_THAT(refused<OverLimit>("", limits).sentence, HasSubstr("gigasteps"));
  EXPECT_THAT(refused<OverLimit>("", limits).sentence, HasSubstr("(max_job_gigasteps)"));
  const auto light = [](int steps) {
    return R"("frames": {"last": 9}, "image": {"width": 1000, "height": 100, "samples": 1},
              "march": {"max_steps": 100, "light_steps": )" +
           std::to_string(steps) + "}";
  };
  EXPECT_EQ(read(light(9), limits).frames(), 10) << "10 frames * 0.1 megapixels * 100 * (1 + 9) steps";
  EXPECT_THROW(read(light(10), limits), OverLimit);
  EXPECT_EQ(read(R"("frames": {"last": 2}, "image": {"width": 64, "height": 36})", limits).frames(), 3);
}

TEST(ReadFrames, TakesARangeOrOneFrame) {
  const auto read = [](const std::string& text) {
    FrameRange range;
    read_frames(text, range);
    return std::pair(range.first, *range.last);
  };
  EXPECT_EQ(read("0-299"), std::pair(0, 299));
  EXPECT_EQ(read("0007-0007"), std::pair(7, 7));
  EXPECT_EQ(read("12"), std::pair(12, 12));
  for (const char* wrong : {"", "-", "3-", "-3", "3-5-7", "a-b", "1-2x", "1 - 2", "1--2", "+1-2", "123456789-3"})
    EXPECT_THAT(refusal([&] { read(wrong); }).sentence, HasSubstr(wrong)) << "and was refused";
  EXPECT_EQ(refusal([&] { read("x"); }).pointer, "--frames");
}

TEST(FramePattern, PadsWithZerosAndNeverCutsDigits) {
  const FramePattern pattern("out/frame_####.png");
  EXPECT_EQ(pattern.file(0), "out/frame_0000.png");
  EXPECT_EQ(pattern.file(123), "out/frame_0123.png");
  EXPECT_EQ(pattern.file(12345), "out/frame_12345.png");
  EXPECT_EQ(FramePattern("#.jpg").file(7), "7.jpg");
  EXPECT_EQ(FramePattern("a/##b").file(7), "a/07b");
}

TEST(FramePattern, RefusesNoneTwoAndThoseOfAFolder) {
  for (const char* wrong : {"frame.png", "a#_#.png", "f#/frame.png", "f#/frame_#.png", ""})
    EXPECT_THAT(refusal([&] { FramePattern{wrong}; }).sentence, HasSubstr("must have one run of #")) << wrong;
}

}  // namespace
}  // namespace cloudscape::settings
