#include "steradian/core/image/image_header.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace steradian {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

std::string word(std::uint32_t value) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 0xFF);
  return text;
}

std::string attribute(std::string_view name, std::string_view type, const std::string& value) {
  return std::string(name) + '\0' + std::string(type) + '\0' + word(static_cast<std::uint32_t>(value.size())) + value;
}

std::string window(std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1) {
  return attribute("dataWindow", "box2i", word(x0) + word(y0) + word(x1) + word(y1));
}

std::string channels(int count) {
  std::string list;
  for (int i = 0; i < count; ++i) list += std::string("c") + std::to_string(i) + '\0' + std::string(16, '\1');
  return attribute("channels", "chlist", list + '\0');
}

const std::string singlePart = "\x76\x2f\x31\x01\x02\0\0\0"s;
const std::string multiPart = "\x76\x2f\x31\x01\x02\x10\0\0"s;

std::optional<ExrExtent> read(const std::string& file) { return readExrExtent(std::as_bytes(std::span(file))); }

TEST(ImageHeader, ReadsAnExrHeader) {
  const auto extent = read(singlePart + channels(4) + window(10, 20, 109, 69) + '\0');
  ASSERT_TRUE(extent.has_value());
  EXPECT_EQ(extent->width, 100u);
  EXPECT_EQ(extent->height, 50u);
  EXPECT_EQ(extent->values, 100u * 50u * 4u);
}

TEST(ImageHeader, NegativeCornersAndWholeRange) {
  EXPECT_EQ(read(singlePart + channels(1) + window(0xFFFFFFFFu, 0, 0, 0) + '\0')->width, 2u);
  // From the least to the largest int: 2^32 on a side.
  const auto all = read(singlePart + channels(1) + window(0x80000000u, 0x80000000u, 0x7FFFFFFFu, 0x7FFFFFFFu) + '\0');
  EXPECT_EQ(all->width, std::uint64_t{1} << 32);
  EXPECT_EQ(all->values, std::uint64_t{1} << 53);
  EXPECT_FALSE(read(singlePart + channels(1) + window(5, 0, 4, 0) + '\0'));
}

TEST(ImageHeader, CountsTilesAndParts) {
  const std::string tiles = attribute("tiles", "tiledesc", word(1000) + word(2000) + '\0');
  EXPECT_EQ(read(singlePart + channels(1) + window(0, 0, 9, 9) + tiles + '\0')->values, 2'000'000u);
  const std::string part = channels(3) + window(0, 0, 9, 9) + '\0';
  EXPECT_EQ(read(multiPart + part + part + '\0')->values, 600u);
}

TEST(ImageHeader, DamagedHeadersAreRefused) {
  const std::string good = singlePart + channels(3) + window(0, 0, 9, 9) + '\0';
  ASSERT_TRUE(read(good));
  for (std::size_t size = 0; size < good.size(); ++size) EXPECT_FALSE(read(good.substr(0, size))) << size;
  EXPECT_FALSE(read(singlePart + window(0, 0, 9, 9) + '\0'));
  EXPECT_FALSE(read(singlePart + channels(3) + '\0'));
}

TEST(ImageHeader, PngChunksMustFit) {
  const auto fits = [](std::string_view rest) {
    const std::string file = "\x89PNG\r\n\x1a\n" + std::string(rest);
    return pngChunksFit(std::as_bytes(std::span(file)));
  };
  EXPECT_TRUE(fits("\0\0\0\x02tEXtabCRC!\0\0\0\x09IDAT"sv));
  EXPECT_FALSE(fits("\0\0\0\x02tEXtabCRC!"sv));
  EXPECT_FALSE(fits("\x7F\0\0\x02tEXtabCRC!\0\0\0\x09IDAT"sv));
  EXPECT_FALSE(fits(""sv));
}

}  // namespace
}  // namespace steradian
