// FrameRequest to Frame. One renderer serves streams, stills and the command line; all on the thread of its context.
//
// A frame is rendered in slices of some milliseconds, so that other frames may go in between:
//   auto job = renderer.begin(request);
//   while (!renderer.advance(*job)) {}
//   Frame frame = renderer.collect(renderer.finish(std::move(job)));
#pragma once
#include <chrono>
#include <map>
#include <memory>

#include "bake/distance_field.h"
#include "bake/store.h"
#include "bake/structure.h"
#include "core/frame.h"
#include "gpu/context.h"
#include "gpu/readback.h"
#include "render/ambient_visibility.h"
#include "render/passes.h"
#include "render/path_tracer.h"
#include "render/resolver.h"
#include "render/sun_depth.h"
#include "render/terrain_stage.h"
#include "render/water_stage.h"

namespace cloudscape::render {

// What a moving frame bakes a slice of where the light changes; the rest it takes as it was. By turns in this order,
// the last two only above water, where there is another sky than above the camera.
enum class LaggingTurn { sky, shadows, water_sky, clouds_in_water };

// A frame that is being rendered.
struct RenderJob {
  FrameRequest request;
  std::shared_ptr<const bake::BakedCloudscape> baked;
  std::shared_ptr<const bake::PhaseTexture> phase;    // where the document's phase function is looked up
  std::shared_ptr<const InScatterVolume> in_scatter;  // where its light model needs one
  std::shared_ptr<const gpu::Texture> sun_depth;      // where clouds cast shadows
  std::shared_ptr<const gpu::Texture> ambient;        // where its light model needs one
  std::optional<bake::DistancePlan> distances;        // of the distance field, where the march has one
  std::optional<SkyTables::Set> sky;
  Land land;
  WaterView water;
  std::optional<LaggingTurn> turn;  // nullopt: all of it
  bool rests(LaggingTurn other) const { return turn && *turn != other; }
  std::unique_ptr<Targets> targets;
  int sample = 0, last_sample = 0;        // indices in the average
  int row = 0;                            // of the march target, next to render
  std::unique_ptr<Trace> trace;           // where the quality's technique is path tracing
  std::optional<ResolvedFrame> resolved;  // a frame of a moving picture: `request` marches its part of it
  gpu::Texture standard_error;            // of a traced picture that is done
  double render_ms = 0;
  gpu::Timer timer;
  PassClock passes;
};

// A frame on its way back from the device.
struct PendingFrame {
  FrameRequest request;
  int samples = 0;
  FrameTimings timings;
  gpu::Readback display, radiance, depth, standard_error;
  std::optional<Enlargement> enlargement;  // of the display
  gpu::Timer timer;
  PassClock passes;
  bool ready() const;
};

class Renderer {
 public:
  // `height_maps`: the folder of the files that terrains may name; empty: none.
  Renderer(const gpu::Context& context, gpu::ShaderLibrary& shaders, bake::BakeStore& bakes,
           std::filesystem::path height_maps = {});
  std::unique_ptr<RenderJob> begin(const FrameRequest& request);
  bool advance(RenderJob& job);  // renders (or first bakes) the next slice; true when all is rendered
  PendingFrame finish(std::unique_ptr<RenderJob> job);
  // Waits if it is not ready. A picture that was rendered small is so still, for another thread to enlarge.
  Frame collect(PendingFrame pending) const;
  Frame render(const FrameRequest& request);  // all of the above
  void abandon(std::unique_ptr<RenderJob> job);
  void forget(StreamId stream);              // frees what is kept to continue the stream's average
  std::vector<StreamId> remembered() const;  // streams that something is kept for
  void reload_shaders();
  std::size_t history_bytes() const;
  std::size_t history_bytes(StreamId stream) const;
  int sky_bakes() const { return sky_.bakes(); }            // tables of the sky computed so far
  int panoramas() const { return water_.panoramas(); }      // of clouds for water, begun so far
  int sun_slices() const { return sun_depths_.slices(); }   // of the clouds' shadows, baked so far
  int ambient_slices() const { return ambient_.slices(); }  // of what clouds let through of sky and ground
  PathTracer& tracer() { return tracer_; }

 private:
  struct History {
    Accumulation accumulation;
    ImageSize size;
    int samples = 0;
  };
  History& history_of(const FrameRequest& request);
  bool find_baked(RenderJob& job);
  bool find_in_scatter(RenderJob& job);
  bool find_distances(RenderJob& job);
  bool find_sun_depth(RenderJob& job);
  bool find_water(RenderJob& job);
  Passes::Medium medium_of(const RenderJob& job);
  Passes::Medium medium_and_scene_of(const RenderJob& job);
  static bake::PhaseRecipe phase_recipe(const Phase& phase);
  bool advance_trace(RenderJob& job);
  void finish_trace(RenderJob& job);
  CloudBlock cloud_values(const RenderJob& job) const;
  const SkyTables::Set& bind_blocks(RenderJob& job, int sample);
  void render_rows(RenderJob& job);
  void finish_sample(RenderJob& job);
  void march_newly_seen(RenderJob& job);
  PendingFrame finish_resolved(std::unique_ptr<RenderJob> job);
  int rows_of_next_slice(const RenderJob& job) const;

  const gpu::Context& context_;
  gpu::ShaderLibrary& shaders_;
  bake::BakeStore& bakes_;
  bake::StructureBuilder structures_;
  bake::DistanceFieldBuilder distances_;
  Passes passes_;
  SkyTables sky_;
  InScatterVolumes in_scatter_;
  CloudDensities densities_;
  SunDepths sun_depths_;
  AmbientVisibilities ambient_;
  TerrainStage terrain_;
  Resolver resolver_;
  WaterStage water_;
  PathTracer tracer_;
  TargetPool pool_;
  std::shared_ptr<gpu::ReadbackBuffers> readbacks_ = std::make_shared<gpu::ReadbackBuffers>();  // of what is displayed
  gpu::UniformBlock<FrameBlock> frame_block_;
  gpu::UniformBlock<CloudBlock> cloud_block_;
  std::map<StreamId, History> histories_;
  double pixels_per_ms_ = 1000;  // march speed, measured; it sizes the slices and changes no pixel
};

}  // namespace cloudscape::render
