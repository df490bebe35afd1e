/**
 * The dialogs of the window: questions, progress, preferences, the examples, the guide and reports of errors; and what
 * opens files and chooses controllers with them. Event dispatch thread only, except for the code that loads the guide,
 * finds controllers, and receives lines of a controller or errors of any thread. They know neither the canvas nor the
 * instruments.
 */
package faultline.gui.dialog;
