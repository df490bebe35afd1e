/**
 * The simulation: the tick and its order, the controller's thread, the timeline, and the journal of commands. A
 * {@link faultline.engine.Simulation} reads no clock and belongs to one thread.
 */
package faultline.engine;
