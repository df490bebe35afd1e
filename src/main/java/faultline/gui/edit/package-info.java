/**
 * What a user does to the scenario: edits with names that can be undone and redone, and what new obstacles are made of.
 * Event dispatch thread only. It knows neither the window nor the canvas; commands go out through a channel, and what
 * became of them comes back.
 */
package faultline.gui.edit;
