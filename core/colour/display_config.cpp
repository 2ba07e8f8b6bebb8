#include "steradian/core/colour/display_config.h"

namespace steradian {

// "sRGB" and "Book" are curves applied directly to the reference space, without a detour through XYZ that would cost
// accuracy. "ACES SDR" is the output transform of ACES 1.x for a video display of 100 nit.
const std::string& displayConfigText() {
  static const std::string text = R"(ocio_profile_version: 2

environment: {}
search_path: ""
strictparsing: true
luma: [0.2126, 0.7152, 0.0722]
description: Steradian's own configuration. Reference space - linear Rec.709 primaries, D65 white.

roles:
  aces_interchange: ACES2065-1
  cie_xyz_d65_interchange: CIE-XYZ-D65
  color_picking: sRGB
  data: Raw
  default: Linear Rec.709
  reference: Linear Rec.709
  rendering: Linear Rec.709
  scene_linear: Linear Rec.709

file_rules:
  - !<Rule> {name: Default, colorspace: default}

displays:
  sRGB:
    - !<View> {name: sRGB, colorspace: sRGB}
    - !<View> {name: ACES SDR, view_transform: ACES SDR, display_colorspace: sRGB - Display}
    - !<View> {name: Book, colorspace: Gamma 2}
    - !<View> {name: Raw, colorspace: Raw}

active_displays: [sRGB]
active_views: [sRGB, ACES SDR, Book, Raw]

view_transforms:
  - !<ViewTransform>
    name: ACES SDR
    from_scene_reference: !<GroupTransform>
      children:
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD, direction: inverse}
        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
        - !<BuiltinTransform> {style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0}

  - !<ViewTransform>
    name: Colorimetry
    from_scene_reference: !<GroupTransform>
      children:
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD, direction: inverse}
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_CIE-XYZ-D65_BFD}

default_view_transform: Colorimetry

display_colorspaces:
  - !<ColorSpace>
    name: CIE-XYZ-D65
    encoding: display-linear
    bitdepth: 32f
    description: CIE XYZ adapted to D65, where white has Y = 1

  - !<ColorSpace>
    name: sRGB - Display
    encoding: sdr-video
    bitdepth: 32f
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}

colorspaces:
  - !<ColorSpace>
    name: Linear Rec.709
    encoding: scene-linear
    bitdepth: 32f

  - !<ColorSpace>
    name: ACES2065-1
    encoding: scene-linear
    bitdepth: 32f
    to_scene_reference: !<GroupTransform>
      children:
        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1, direction: inverse}
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD}

  - !<ColorSpace>
    name: sRGB
    encoding: sdr-video
    bitdepth: 32f
    from_scene_reference: !<ExponentWithLinearTransform> {gamma: [2.4, 2.4, 2.4, 1], offset: [0.055, 0.055, 0.055, 0], direction: inverse}

  - !<ColorSpace>
    name: Gamma 2
    encoding: sdr-video
    bitdepth: 32f
    description: Square root, as in "Ray Tracing in One Weekend"
    from_scene_reference: !<ExponentTransform> {value: [2, 2, 2, 1], direction: inverse}

  - !<ColorSpace>
    name: Raw
    isdata: true
    bitdepth: 32f
)";
  return text;
}

}  // namespace steradian
