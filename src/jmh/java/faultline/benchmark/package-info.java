/** Benchmarks, compiled and run in the {@code jmh} profile only; see docs/benchmarks.md. */
package faultline.benchmark;
