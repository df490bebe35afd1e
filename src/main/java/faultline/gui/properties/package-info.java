/**
 * Forms for the properties of a scenario and of its obstacles, and the dialogs that start a new scenario from a
 * template or a floor plan. Event dispatch thread only, except for what reads files.
 */
package faultline.gui.properties;
