// An outside project, which uses only the installed package: builds scenes, renders two of them at once in its own
// arenas, stops one of them, and reads pixels.
#include <steradian/integrators/path/path.h>
#include <steradian/integrators/render/render.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <thread>

namespace {

using namespace steradian;

/// A white sphere in a grey sky.
SceneDescription sphereIn(float sky) {
  SceneDescription scene;
  const Id white = scene.addMaterial("white", LambertMaterial{scene.addColour({1.0f, 1.0f, 1.0f})});
  scene.addShape("ball", SphereSet{{0.0f}, {0.0f}, {0.0f}, {1.0f}}, white);
  scene.addLight("sky", ConstantSky{{sky, sky, sky}});
  scene.camera = PerspectiveCamera{.lookFrom = {0.0f, 0.0f, 4.0f}, .lookAt = {0.0f, 0.0f, 0.0f}};
  return scene;
}

bool expect(bool good, const char* what) {
  if (!good) std::fprintf(stderr, "wrong: %s\n", what);
  return good;
}

RenderSettings settingsFor(std::uint32_t samplesPerPixel) {
  RenderSettings settings;
  settings.width = 32;
  settings.height = 24;
  settings.samplesPerPixel = samplesPerPixel;
  return settings;
}

}  // namespace

int main() {
  try {
    const Scene bright(sphereIn(0.75f)), dark(sphereIn(0.25f));
    const PathIntegrator integrator;
    std::optional<RenderResult> finished, stopped;
    std::atomic<int> calls = 0;

    std::thread first([&] {
      tbb::task_arena arena(1);
      arena.execute(
          [&] { finished = render(bright, integrator, settingsFor(16), {}, [&](const RenderProgress&) { ++calls; }); });
    });
    std::thread second([&] {
      std::stop_source source;
      tbb::task_arena arena(1);
      arena.execute([&] {
        stopped = render(dark, integrator, settingsFor(1000000), source.get_token(), [&](const RenderProgress& p) {
          if (p.samplesPerPixel >= 4) source.request_stop();
        });
      });
    });
    first.join();
    second.join();

    bool good = expect(calls > 0, "there was no progress");
    good &= expect(!finished->stopped && stopped->stopped, "who was stopped");
    good &= expect(finished->film.sampleCount(16, 12) == 16, "the number of samples");
    good &= expect(stopped->film.sampleCount(16, 12) >= 4, "the samples before the stop");
    // A white convex body in an even sky is as bright as the sky.
    good &= expect(std::abs(finished->film.radiance(16, 12).g - 0.75f) < 1e-4f, "the bright pixel");
    good &= expect(std::abs(stopped->film.radiance(16, 12).g - 0.25f) < 1e-4f, "the dark pixel");
    const Image image = finished->film.image();
    good &= expect(image.at(16, 12, image.channel("A")) == 1.0f, "alpha on the ball");
    good &= expect(image.at(0, 0, image.channel("A")) == 0.0f, "alpha beside the ball");
    std::printf("two pictures: %.4f and %.4f\n", static_cast<double>(finished->film.radiance(16, 12).g),
                static_cast<double>(stopped->film.radiance(16, 12).g));
    return good ? 0 : 1;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
