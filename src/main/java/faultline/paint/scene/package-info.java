/**
 * Painters of a frame: obstacles, robot, sensor cones, path and collisions, shared by the window's canvas and by
 * picture files. They read immutable frames and draw on a surface; nothing here knows of components, events or a
 * display.
 */
package faultline.paint.scene;
