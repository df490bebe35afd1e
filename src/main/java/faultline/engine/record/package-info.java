/**
 * What is remembered of a run while it goes on: traces of numbers, the events, how long each state lasted, and pictures
 * of moments. Each kind has a recorder that one thread writes, and a view that any thread may keep and read without a
 * lock: what a view shows is never written again, and it is published after its last entry. All of them are bounded, so
 * that a run of days needs no more memory than a run of minutes.
 */
package faultline.engine.record;
