// Constants of the planet and of mathematics.
#ifndef LIB_CONSTANTS
#define LIB_CONSTANTS
const float pi = 3.14159265359;
const float golden_ratio = 0.61803398875;
const float planet_radius_m = 6360000.0;      // Bruneton 2017, Hillaire 2020
const float atmosphere_top_m = 100000.0;      // altitude; Hillaire 2020
const float no_hit_m = 1.0e9;                 // distance of a ray that meets nothing
#endif
