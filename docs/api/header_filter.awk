# SPDX-License-Identifier: BSD-3-Clause
# What Doxygen reads of a public header: the sentence at its top becomes the text of the file's page, and what it
# declares goes to the header's topic (topics.dox), so that the headers themselves need no commands. Lines stay where they
# are.
BEGIN {
  add("segmentation", "plane_extractor plane_segmentation line_segment doubts status plane_fit line_fit")
  add("parameters", "parameters inverse_depth_parameters paper_parameters parameter_table")
  add("frames", "depth_frame depth_view projection cloud_geometry")
  add("sensor", "sensor_model sensor_estimation")
  add("pcl_class", "pcl/epcc_segmentation epcc_segmentation")
  add("surfaces", "contours label_arcs surface_polygon plane_edges surface_mesh surface_sampling")
  add("laser", "laser_line_extractor laser_scan range_noise")
  add("stream", "scan_line_stream stream_geometry")
  add("over_time", "plane_tracker known_planes")
  add("support", "vectors on_threads vector_unit export")
}

function add(topic, headers,    names, i) {
  split(headers, names, " ")
  for (i in names) topic_of[names[i]] = topic
}

FNR == 1 {
  header = FILENAME
  sub(/.*\/include\/epcc_segmentation\//, "", header)
  sub(/\.h$/, "", header)
  topic = topic_of[header]
  if (topic == "") {
    printf "%s: warning: the header has no topic in docs/api/header_filter.awk\n", FILENAME > "/dev/stderr"
  }
  in_top = 1
  print "/// \\file"
  next
}

in_top && /^\/\/ / { print text("/" $0); next }
in_top { in_top = 0; print topic == "" ? "" : "/// \\ingroup " topic; next }  # in place of #pragma once

# Definitions outside of their class would be listed once more.
/^inline [^(]*[A-Z][A-Za-z]*::[A-Za-z]+\(/ { is_outside = 1 }
is_outside { if (/^\}/) is_outside = 0; print ""; next }

/\/\/\// { $0 = text($0) }

topic == "" { print; next }
/^namespace epcc \{/ { print "namespace epcc { /** \\addtogroup " topic " */ /** \\{ */"; next }
/^\}  \/\/ namespace epcc/ { print "/** \\} */ }"; next }
{ print }

# "Eq. 22" is not the end of a sentence, as the backslash tells Doxygen. A sentence that begins with "Planes" does not
# speak of the struct of that name: % keeps Doxygen from a link to it.
function text(line) {
  gsub(/Eq\. /, "Eq.\\ ", line)
  gsub(/Sec\. /, "Sec.\\ ", line)
  gsub(/Fig\. /, "Fig.\\ ", line)
  gsub(/ Planes /, " %Planes ", line)
  gsub(/ Lines /, " %Lines ", line)
  gsub(/ Parameters /, " %Parameters ", line)
  return line
}
