//! Sets that enclose: zonotopes and their operations, rounding included.
