#pragma once
/// Which symbols a shared libsteradian exports.
///
/// Everything is compiled with hidden visibility, so that calls within the library cannot be redirected and its symbols
/// do not clash with those of other libraries. Exported is what headers declare in `namespace STERADIAN_API steradian`:
/// all installed headers, except for the tables of kernels. A static library exports nothing, so neither does a shared
/// library that contains it.
#if defined(STERADIAN_SHARED)
#define STERADIAN_API [[gnu::visibility("default")]]
#else
#define STERADIAN_API
#endif
