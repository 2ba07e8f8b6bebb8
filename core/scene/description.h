#pragma once
/// The scene as plain data: what a file reader or a C++ program fills in, and Scene is built from.
///
/// Ids are indices into the vectors of SceneDescription; kNone means "none". Lengths are scene units (m), angles are
/// degrees, colours are linear Rec.709. Bulk sets are structures of arrays, so that 10^7 boxes are a few vectors.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/image/image.h"
#include "steradian/core/math/motion.h"
#include "steradian/core/scene/custom_shape.h"
#include "steradian/core/transport/spectrum.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

using Id = std::uint32_t;

// --- Textures ---------------------------------------------------------------------------------------------------

struct ConstantTexture {
  Rgb value{};
};
/// Alternates between two textures: in cubes of edge `scale` in world space ("The Next Week", 4.3), or in `scale` x
/// `scale` cells over (u, v).
struct CheckerTexture {
  enum class Space { World, Uv };
  Id even = kNone, odd = kNone;  ///< textures; even is where the sum of the cell indices is even
  float scale = 1.0f;            ///< World: edge of a cell, scene units; Uv: number of cells along u and v
  Space space = Space::World;
};
/// A picture over (u, v): u runs to the right, v upwards, (0, 0) is the lower left corner of the picture. Its colours
/// are reflectances: they are clamped to [0, 1] at lookup.
struct ImageTexture {
  /// The colours outside of the picture.
  enum class Wrap { Repeat, Mirror, Clamp, Black };
  enum class Filter { Nearest, Bilinear };
  std::string name{};                  ///< shown to users: the file that it came from
  std::shared_ptr<const Image> image;  ///< linear colours: R, G and B, or one channel for all three
  Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
  Filter filter = Filter::Bilinear;
  float repeatU = 1.0f, repeatV = 1.0f;  ///< how often the picture repeats over u and v from 0 to 1
};
/// Perlin's noise in world space ("The Next Week", 5), in [0, 1] times a colour.
struct NoiseTexture {
  enum class Pattern {
    Noise,       ///< (1 + noise) / 2
    Turbulence,  ///< |sum of octaves|, each of twice the frequency and half the size, at most 1
    Marble       ///< (1 + sin(scale z + 10 turbulence)) / 2, the turbulence being that of the unscaled position
  };
  Pattern pattern = Pattern::Marble;
  Rgb colour{1.0f, 1.0f, 1.0f};
  float scale = 1.0f;  ///< Noise, Turbulence: cells per scene unit; Marble: radians per scene unit
  int octaves = 7;     ///< of turbulence, 1..16
  std::uint32_t seed = 0;
};
using TextureDescription = std::variant<ConstantTexture, CheckerTexture, ImageTexture, NoiseTexture>;

// --- Materials --------------------------------------------------------------------------------------------------

/// Absorbs all light: the usual material of an area light.
struct AbsorberMaterial {};
struct LambertMaterial {
  Id reflectance = kNone;  ///< texture, 0..1
};
/// The books' metal: mirror direction plus a point in a sphere of radius `fuzz` in [0, 1]; 0 is a mirror.
struct MetalMaterial {
  Id reflectance = kNone;  ///< texture, 0..1
  float fuzz = 0.0f;
};
/// Smooth interface. On shapes with a priority (see Interior) eta is the refractive index inside, and the index outside
/// is that of the body that the ray comes from; on others eta is inside over outside, below 1 for a bubble.
struct DielectricMaterial {
  float eta = 1.5f;      ///< > 0
  bool schlick = false;  ///< Schlick's approximation with the incident side's cosine, as the books do; else exact
};
/// Varnished wood: a smooth Fresnel coat over Lambert.
struct CoatedMaterial {
  Id reflectance = kNone;  ///< texture of the base, 0..1
  float eta = 1.5f;
};
/// Scatters uniformly into the hemisphere: f |cos| = reflectance / (2 pi), the "hemisphere" material of "The Rest of
/// Your Life" (6). Not reciprocal: no real surface does this.
struct UniformDiffuseMaterial {
  Id reflectance = kNone;  ///< texture, 0..1
};
/// An invisible boundary between media, which rays cross unchanged. Where it coincides with a visible surface, as the
/// bottom of a cloud that lies on a floor, the visible surface should come first among the shapes.
struct InterfaceMaterial {};
using MaterialModel = std::variant<AbsorberMaterial, LambertMaterial, MetalMaterial, DielectricMaterial, CoatedMaterial,
                                   UniformDiffuseMaterial, InterfaceMaterial>;
struct MaterialDescription {
  std::string name;
  MaterialModel model;
  SourceRange where;
};

// --- Media ------------------------------------------------------------------------------------------------------

/// A homogeneous medium with the phase function of Henyey and Greenstein. The extinction is absorption + scattering.
struct MediumDescription {
  std::string name{};
  Rgb absorption{}, scattering{};  ///< 1/m
  Rgb emission{};                  ///< W sr^-1 m^-3: the radiance that a ray gains per metre
  float anisotropy = 0.0f;         ///< mean cosine of the scattering angle, in (-1, 1)
  SourceRange where{};
};
/// What fills a closed shape. Where several shapes overlap, that of the highest priority counts; among equal
/// priorities, that of the shape entered last.
struct Interior {
  Id medium = kNone;  ///< kNone: vacuum
  /// If above 0, rays ignore the surface inside of shapes with a higher priority, so that glass and the liquid in it
  /// may overlap (Schmidt & Budge 2002, "Simple nested dielectrics in ray traced images"). 0: they never ignore it.
  int priority = 0;
};

// --- Shapes -----------------------------------------------------------------------------------------------------

/// Spheres by centre and radius (> 0).
struct SphereSet {
  std::vector<float> centerX, centerY, centerZ, radius;
  std::vector<float> moveX{}, moveY{}, moveZ{};  ///< the centre's way from time 0 to time 1; empty if none moves

  void add(Vec3f center, float sphereRadius);
  /// From one centre to the other while the shutter is open. Sets may mix both kinds.
  void addMoving(Vec3f from, Vec3f to, float sphereRadius);
};
/// Parallelograms corner + s u + t v, s and t in [0, 1]; the normal is along u x v ("The Next Week", 6).
struct QuadSet {
  std::vector<float> cornerX, cornerY, cornerZ, uX, uY, uZ, vX, vY, vZ;

  void add(Vec3f corner, Vec3f u, Vec3f v);
};
/// Boxes by centre, half edge lengths and a unit quaternion (w + xi + yj + zk); no quaternions: all axis-aligned.
struct BoxSet {
  std::vector<float> centerX, centerY, centerZ, halfX, halfY, halfZ;
  std::vector<float> rotationW, rotationX, rotationY, rotationZ;

  void add(Vec3f center, Vec3f half);
  /// Turned by `degrees` about the y axis, counter-clockwise seen from above ("The Next Week", 8.2). Boxes of one set
  /// are added by the same of the two functions.
  void addRotatedY(Vec3f center, Vec3f half, float degrees);
};
struct DiskSet {
  std::vector<float> centerX, centerY, centerZ, normalX, normalY, normalZ, radius;  ///< normals of unit length

  void add(Vec3f center, Vec3f normal, float diskRadius);
};
struct TriangleMesh {
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise seen from outside
  std::vector<Vec3f> normals;          ///< per vertex, or empty
  std::vector<Vec2f> uvs;              ///< per vertex, or empty: barycentric (v, w)
};
/// The extension point: shapes of the user's own (see core/scene/custom_shape.h).
struct CustomShapeSet {
  std::vector<std::shared_ptr<const CustomShape>> shapes;
};
using ShapeGeometry = std::variant<SphereSet, QuadSet, BoxSet, DiskSet, TriangleMesh, CustomShapeSet>;

/// Number of primitives of a set.
std::size_t primitiveCount(const ShapeGeometry& geometry);
/// The name users know a set's primitives by: "sphere", "quad", "box", "disk", "triangle", "custom".
const char* primitiveName(const ShapeGeometry& geometry);

struct ShapeDescription {
  std::string name;
  ShapeGeometry geometry;
  Id material = kNone;
  std::vector<Id> primitiveMaterials;  ///< one per primitive, or empty: `material` for all
  Id emission = kNone;                 ///< if set, every primitive is an area light
  bool target = false;                 ///< a sampling target; for `mixture` any flag replaces the set "lights"
  std::optional<Interior> interior;    ///< of closed shapes
  std::optional<Motion> motion;        ///< local to world; none: coordinates are those of the world (or group)
  SourceRange where;
};

/// Shapes that are placed by instances only (core/scene/placements.h expands them).
struct Group {
  std::string name;
  std::vector<Id> shapes;
};
/// Copies of a group: local to world, affine, invertible.
struct InstanceSet {
  Id group = kNone;
  std::vector<Matrix> transforms;
  std::vector<Matrix> closing{};  ///< those at time 1, `transforms` being those at time 0 (see Motion); empty: at rest
  SourceRange where{};
};

// --- Lights -----------------------------------------------------------------------------------------------------

/// Emission of a surface: radiance, constant over surface and directions.
struct SurfaceEmission {
  Rgb radiance{};         ///< W sr^-1 m^-2
  bool twoSided = false;  ///< otherwise only the side of the outward normal emits
};
struct PointLight {
  Vec3f position{};
  Rgb intensity{};  ///< W sr^-1
};
/// Full intensity within `innerAngle` of the axis, smoothstep of the cosine down to zero at `outerAngle`.
struct SpotLight {
  Vec3f position{}, direction{};                 ///< the axis, of any length
  Rgb intensity{};                               ///< W sr^-1
  float innerAngle = 25.0f, outerAngle = 30.0f;  ///< degrees from the axis
};
struct DistantLight {
  Vec3f direction{};  ///< the way the light travels
  Rgb irradiance{};   ///< W m^-2 on a surface that faces it
};
/// The same radiance from all directions.
struct ConstantSky {
  Rgb radiance{};  ///< W sr^-1 m^-2
};
/// The books' sky: linear in y of the unit direction, from nadir (y = -1) to zenith (y = 1).
struct GradientSky {
  Rgb nadir{}, zenith{};  ///< W sr^-1 m^-2
};
/// A picture of the whole sphere of directions, equirectangular: up (+y) at the top, and in the middle of the picture
/// -z, turned by `rotation` about +y.
struct ImageSky {
  std::string name{};                  ///< shown to users: the file that it came from
  std::shared_ptr<const Image> image;  ///< linear: R, G and B, or one channel for all three
  Rgb scale{1.0f, 1.0f, 1.0f};         ///< W sr^-1 m^-2 per unit of the picture
  float rotation = 0.0f;               ///< degrees, counter-clockwise seen from above
};
using LightModel = std::variant<PointLight, SpotLight, DistantLight, ConstantSky, GradientSky, ImageSky>;
struct LightDescription {
  std::string name;
  LightModel model;
  SourceRange where;
};

// --- Camera and film --------------------------------------------------------------------------------------------

/// Thin lens in the books' terms. `verticalFov` spans the image's height.
struct PerspectiveCamera {
  Vec3f lookFrom{0.0f, 0.0f, 0.0f}, lookAt{0.0f, 0.0f, -1.0f}, up{0.0f, 1.0f, 0.0f};
  float verticalFov = 40.0f;   ///< degrees
  float defocusAngle = 0.0f;   ///< degrees: apex angle of the cone from the focus point to the lens; 0: pinhole
  float focusDistance = 1.0f;  ///< scene units, along the optical axis
};
struct OrthographicCamera {
  Vec3f lookFrom{0.0f, 0.0f, 0.0f}, lookAt{0.0f, 0.0f, -1.0f}, up{0.0f, 1.0f, 0.0f};
  float height = 2.0f;  ///< of the image, scene units
};
/// Equirectangular: the whole sphere of directions, up at the top, lookAt in the middle.
struct SphericalCamera {
  Vec3f lookFrom{0.0f, 0.0f, 0.0f}, lookAt{0.0f, 0.0f, -1.0f}, up{0.0f, 1.0f, 0.0f};
};
using CameraDescription = std::variant<PerspectiveCamera, OrthographicCamera, SphericalCamera>;

/// The settings that a scene is rendered with unless the command line says otherwise.
struct RenderDefaults {
  int width = 600, height = 600;
  std::uint32_t samplesPerPixel = 64;
  int maxDepth = 49;  ///< bounces (0: emission only): the books' max_depth less one
};

struct SceneDescription {
  std::string name;
  std::vector<TextureDescription> textures;
  std::vector<MaterialDescription> materials;
  std::vector<MediumDescription> media;
  Id outside = kNone;  ///< the medium around everything; kNone: vacuum
  std::vector<SurfaceEmission> emissions;
  std::vector<ShapeDescription> shapes;
  std::vector<Group> groups;
  std::vector<InstanceSet> instances;
  std::vector<LightDescription> lights;
  CameraDescription camera;
  RenderDefaults defaults;

  // Conveniences for programs that write scenes by hand; each returns the new id and checks nothing
  // (validate() does).
  Id addTexture(TextureDescription texture);
  Id addColour(Rgb value);  ///< a ConstantTexture
  Id addMaterial(std::string materialName, MaterialModel model);
  Id addMedium(MediumDescription medium);
  Id addShape(std::string shapeName, ShapeGeometry geometry, Id material);
  void setEmission(Id shape, SurfaceEmission emission);  ///< makes the shape an area light
  Id addLight(std::string lightName, LightModel model);
};

/// Everything that is wrong with a description, all at once: ids out of range, sets of unequal length, non-finite or
/// degenerate shapes, reflectances outside [0, 1], texture cycles, singular transforms. Empty: it can be built.
Diagnostics validate(const SceneDescription& scene);

}  // namespace steradian
