/**
 * The simulation: the tick and its order, the controller's thread, the timeline, and the journal of commands. A
 * {@link faultline.engine.Simulation} reads no clock and belongs to one thread.
 *
 * <p>The words, in order: a {@code SimulationSetup} determines a run, and a {@code Simulation} makes its ticks. At any
 * moment, the run has {@code RunMeasures} from ground truth, and {@code RunFacts}, with which expectations are
 * compared. A run without a window ends with a {@code RunResult}; one in a window is kept as a {@code Journal}, which
 * repeats it, and a {@code Recording}, which shows it. A {@code ReferenceRun} is an earlier run that a journal has
 * repeated.
 */
package faultline.engine;
