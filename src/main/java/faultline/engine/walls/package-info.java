/**
 * The walls of a world as ground truth: the places from which they can be followed at a distance, the closed paths that
 * these form, the share of them that a robot has passed, and the nearest wall of a point. Each object belongs to the
 * thread of its run, except for a {@link faultline.engine.walls.WallCircuit}, which is immutable. Nothing here depends
 * on controllers or on what a run is judged by.
 */
package faultline.engine.walls;
