/**
 * Infrared cone sensors: their mounting and settings, their readings, and the faults that change their readings.
 * Immutable values and pure functions on any thread, but for the random numbers of a tick and the state of an active
 * fault, which belong to the simulation thread, and lookups of equal faults, which belong to their users. Nothing here
 * depends on what carries a sensor or uses its reading.
 */
package faultline.sensor;
