// Linked into sanitized builds: no library is ever unloaded. Mesa's drivers hold memory in their own globals until
// exit; once their libraries are unloaded at the display's end, LeakSanitizer can no longer reach it and reports leaks
// without a name.
extern "C" int dlclose(void*) noexcept { return 0; }
