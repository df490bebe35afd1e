/**
 * Edits of the scenario: named edits that can be undone, the commands that do not show yet, and the shapes of new
 * obstacles. Event dispatch thread only. It knows neither the window nor the canvas; commands are sent through a
 * channel, which returns their results.
 */
package faultline.gui.edit;
