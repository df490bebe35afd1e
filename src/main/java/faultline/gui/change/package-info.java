/**
 * What executed commands change in a scenario: its setup from the start, and the events on its timeline; and changes of
 * the ids of sensors and obstacles. Computes with values only: knows neither the document nor a run, and no Swing. An
 * editor belongs to one document and its thread.
 */
package faultline.gui.change;
