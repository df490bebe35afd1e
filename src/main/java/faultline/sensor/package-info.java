/**
 * Infrared cone sensors: their mounting and settings, their readings, and the faults that change their readings.
 * Immutable values and pure functions on any thread. Nothing here depends on what carries a sensor or uses its reading.
 */
package faultline.sensor;
