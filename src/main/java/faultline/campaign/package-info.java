/**
 * Studies of many runs: random rooms by seed, and the judgement of a run from ground truth. Immutable values and
 * objects of one thread; nothing here reads a clock or a file.
 */
package faultline.campaign;
