/**
 * Campaigns: makes the runs of a plan on several threads and writes one row per run, in the order of the plan. Rows are
 * forced to the disk during the campaign, so that it can be resumed after any interruption. Its table has the same
 * bytes for any division into parts. Simulations run on a pool of threads; all files are written by the calling thread.
 */
package faultline.campaign.run;
