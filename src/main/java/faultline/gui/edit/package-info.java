/**
 * Edits of the scenario: named edits that can be undone, the commands that have no effect in a frame yet, and the
 * shapes of new obstacles. Event dispatch thread only. Does not depend on the window and the canvas; commands are sent
 * through a channel, which returns their results.
 */
package faultline.gui.edit;
