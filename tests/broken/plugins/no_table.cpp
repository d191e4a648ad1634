/// A library that is no plugin.
extern "C" int some_function() { return 1; }
