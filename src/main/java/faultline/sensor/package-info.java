/**
 * Infrared cone sensors: how one is mounted, what it truly sees, and how its faults distort what it reports. Immutable
 * values and pure functions on any thread; nothing here knows what carries the sensor or what is done with its reading.
 */
package faultline.sensor;
