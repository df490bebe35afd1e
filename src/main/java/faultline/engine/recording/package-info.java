/**
 * The data that a run records: traces of numbers, events, state durations, and hashes. Each kind has a recorder,
 * written by one thread, and an immutable view that any thread may read without a lock. All recordings are bounded, so
 * a run of days takes no more memory than a run of minutes.
 */
package faultline.engine.recording;
