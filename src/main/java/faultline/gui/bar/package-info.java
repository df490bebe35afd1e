/**
 * The bars of the window: the tool bar above the canvas, the column of obstacles beside it, and the status bar below
 * it, whose notes stay for as long as they take to read. They show actions and the status of a run; they know neither
 * the canvas nor the window. Event dispatch thread only.
 */
package faultline.gui.bar;
