# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the tables of mass.sh from its results, and returns 1 if the test fails.  Standard input
# has one line for each file: checksum and path.
# Variables: results (the folder), max_faces, max_refused (in percent)

# Returns a sentence without the name of the file, without quoted words and without numbers.
# Similar sentences are then equal.
function reason(sentence, file,    begin)
{
  sub(/^geodesic: /, "", sentence)
  begin = index(sentence, file ": ")
  if(begin > 0)
    sentence = substr(sentence, 1, begin - 1) substr(sentence, begin + length(file) + 2)
  gsub(/'[^']*'/, "NAME", sentence)
  gsub(/-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?/, "N", sentence)
  return sentence
}

function add_failure(list, file, command, sentence)
{
  ++number_of_failures[list]
  failures[list] = failures[list] "- " file ": `" command "`: " sentence "\n"
}

function add_refusal(file, command, sentence,    key)
{
  ++refused[command]
  key = reason(sentence, file)
  if(!refusals[key]++)
    example[key] = file
  if(!is_listed[key, command]++)
    refusing_commands[key] = refusing_commands[key] (refusals[key] > 1 ? ", " : "") "`" command "`"
}

function print_list(title, list)
{
  printf("\n## %s: %d\n\n%s", title, number_of_failures[list], failures[list])
}

{
  ++number_of_files
  folder = results "/" $1
  file = $2
  faces = 0
  while((getline line < (folder "/json")) > 0)
    if(line ~ /^info\t/)
    {
      number_of_clouds += line ~ /"kind": "cloud"/
      if(match(line, /"faces": [0-9]+/))
        faces = substr(line, RSTART + 9, RLENGTH - 9) + 0
    }
  close(folder "/json")
  is_refused = 0
  while((getline line < (folder "/runs")) > 0)
  {
    split(line, field, "\t")
    command = field[1]
    code = field[2]
    ++number_of_runs
    ++runs[command]
    hundredths = int(100 * field[3] + 0.5)
    ++histogram[command, hundredths]
    if(hundredths > longest[command])
      longest[command] = hundredths
    if(code == 0)
      ++succeeded[command]
    else if(code == 2)
    {
      add_refusal(file, command, field[5])
      is_refused = 1
    }
    else if(code == 124 || code == 137 || code == 152) # real time, killed, processor time
    {
      ++without_end[command]
      add_failure(faces > max_faces ? "large" : "slow", file, command, faces " faces")
    }
    else
    {
      ++crashed[command]
      add_failure("crash", file, command, "exit code " code ": " field[5])
    }
  }
  close(folder "/runs")
  number_of_refused_files += is_refused
  while((getline line < (folder "/violations")) > 0)
  {
    split(line, field, "\t")
    add_failure("violation", file, field[1], field[2])
  }
  close(folder "/violations")
}

END {
  printf("# Mass test: %d runs on %d files, of which %d have no faces\n\n", number_of_runs,
         number_of_files, number_of_clouds)
  print "| command | runs | succeeded | refused | without end | crashed | median, s | longest, s |"
  print "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
  number_of_commands = split("info exact front path sample voronoi segment remesh semiregular " \
                             "flatten atlas emd", commands, " ")
  for(i = 1; i <= number_of_commands; ++i)
  {
    command = commands[i]
    median = -1
    for(sum = 0; 2 * sum < runs[command]; sum += histogram[command, median])
      ++median
    printf("| `%s` | %d | %d | %d | %d | %d | %.2f | %.2f |\n", command, runs[command],
           succeeded[command], refused[command], without_end[command], crashed[command],
           (median < 0 ? 0 : median) / 100, longest[command] / 100)
  }

  percentage = number_of_files ? 100 * number_of_refused_files / number_of_files : 0
  printf("\n## Files that a command refuses: %d, %.1f %%\n\n", number_of_refused_files, percentage)
  print "| runs | commands | sentence | example |"
  print "| ---: | --- | --- | --- |"
  fflush()
  sort = "sort -t '|' -k 2,2nr"
  for(key in refusals)
    printf("| %d | %s | %s | %s |\n", refusals[key], refusing_commands[key], key, example[key]) | sort
  close(sort)

  print_list("Crashes", "crash")
  print_list("Runs without end", "slow")
  print_list("Runs without end on more than " max_faces " faces, which are not failures", "large")
  print_list("Violated invariants", "violation")
  if(number_of_failures["crash"] + number_of_failures["slow"] + number_of_failures["violation"] > 0 ||
     percentage > max_refused || number_of_runs == 0)
    exit 1
}
