/**
 * The flat look of the window, light and dark: Metal with a theme, UI defaults, and a small delegate for each control
 * that looks different; and vector icons. Event dispatch thread only. Nothing here depends on the simulation, except
 * for the canvas palette of each theme.
 */
package faultline.gui.theme;
