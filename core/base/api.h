#pragma once
/// What a shared libsteradian shows of itself.
///
/// Everything is compiled with hidden names, so that calls within the library stay there and nothing of it meets
/// names of other libraries. The interface is what headers declare in `namespace STERADIAN_API steradian`: all
/// installed ones, but for the tables of kernels. In a static library nothing is shown: a shared library that is
/// built with one keeps it to itself.
#if defined(STERADIAN_SHARED)
#define STERADIAN_API [[gnu::visibility("default")]]
#else
#define STERADIAN_API
#endif
