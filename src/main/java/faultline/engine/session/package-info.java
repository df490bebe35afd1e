/**
 * Interactive runs: a {@link faultline.engine.session.Session} owns the simulation thread, takes commands from any
 * thread, paces the run and publishes immutable frames; journals replay here. The only packages below that read a clock
 * are named by the layer test.
 */
package faultline.engine.session;
