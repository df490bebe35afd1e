/**
 * Floor plans from occupancy-grid maps: reads a ROS map_server YAML file or an image, classifies its cells, traces the
 * exact outlines of the solid ones and makes a scenario from them. Pure functions and blocking reads, safe on any
 * thread.
 */
package faultline.floorplan;
