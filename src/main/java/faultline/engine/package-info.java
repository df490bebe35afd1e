/**
 * Time: the tick and its order, the controller's thread and the hand-over to it, pacing, the journal and replay. A
 * {@link faultline.engine.Simulation} holds no clock and belongs to one thread; a
 * {@link faultline.engine.session.Session} owns that thread for an interactive run, takes commands from any thread and
 * publishes frames to all.
 */
package faultline.engine;
