/**
 * The ground floor: vectors, poses, rigid motion, sectors, and exact distances between plane figures. Everything here
 * is an immutable value or a pure function in metres and radians, safe on any thread, and knows nothing of robots or
 * time. Transcendental functions are {@link java.lang.StrictMath}'s, so that every machine computes the same bits.
 */
package faultline.geometry;
