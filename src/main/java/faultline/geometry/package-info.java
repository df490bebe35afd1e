/**
 * The lowest layer: vectors, poses, rigid motions, sectors, and exact distances between plane shapes. Everything here
 * is an immutable value or a pure function in metres and radians, safe on any thread, except for
 * {@link faultline.geometry.SectorDistance}, which moves and belongs to one thread. Nothing depends on other packages.
 * Transcendental functions are those of {@link java.lang.StrictMath}, so that every machine computes the same bits.
 */
package faultline.geometry;
