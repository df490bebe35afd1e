/**
 * Campaigns: makes the runs of a plan on several threads and writes one row a run, in the order of the plan. Rows are
 * forced to the disk as they come, so that a campaign goes on after any interruption and its table has the same bytes
 * however it was divided. Simulations run on a pool of threads; all files are written by the calling thread.
 */
package faultline.campaign.run;
