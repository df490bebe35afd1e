/**
 * Interactive runs: a {@link faultline.engine.session.Session} owns the simulation thread, takes commands from any
 * thread, paces the run, publishes immutable frames and replays journals. Of the packages below, only those that the
 * layer test names read a clock.
 */
package faultline.engine.session;
