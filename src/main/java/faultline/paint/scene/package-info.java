/**
 * Painters of a frame: obstacles, robot, sensor cones, path and collisions, shared by the window's canvas, picture
 * files and figures. They read immutable frames and draw on a surface; they do not use components, events or a display.
 */
package faultline.paint.scene;
