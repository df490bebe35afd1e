/**
 * Forms for the properties of a scenario and of its obstacles, and the dialogs that start a new scenario from a
 * template or a floor plan. Event dispatch thread only, except for the code that reads files.
 */
package faultline.gui.properties;
